// SPDX-License-Identifier: MIT
// Hearing one stream: which one, how loud, how late.
import { effect, signal } from "@preact/signals";

import { probe } from "../shell/counters";
import { testing } from "../shell/router";
import { stored } from "../shell/stored";
import type { AudioBlock } from "../socket/binary";
import type { AudioWish } from "../socket/messages";
import type { JitterReport } from "./jitter";
import { makeOutput, type Output } from "./output";

/** Samples that a test may take back: 30 s at 16 kHz. */
const kTapMost = 480000;

const kNothing: JitterReport = { waiting: 0, target: 0, underruns: 0, played: 0, skipped: 0, missing: 0, playing: false, index: -1 };

export function sameWish(a: AudioWish | null, b: AudioWish | null): boolean {
  return a === b || (a !== null && b !== null && a.stream === b.stream && a.track === b.track && a.mic === b.mic);
}

export class Listener {
  /** What is heard; null: nothing. */
  readonly wish = signal<AudioWish | null>(null);
  readonly volume = stored("volume", 1, (value) => (typeof value === "number" && value >= 0 && value <= 1 ? value : 1));
  readonly muted = signal(false);
  /** Milliseconds from a block's arrival to its sound; null: silent. */
  readonly latency = signal<number | null>(null);
  readonly underruns = signal(0);
  /** The browser wants a click before it plays. */
  readonly blocked = signal(false);
  /** The stream of this track has ended. */
  readonly over = signal(false);

  /** What is played, for pictures of it; null until something is. */
  analyser: AnalyserNode | null = null;

  private context: AudioContext | null = null;
  private gain: GainNode | null = null;
  private output: Output | null = null;
  private making: Promise<void> | null = null;
  private report = kNothing;
  private early: AudioBlock[] = [];
  private blocks = 0;
  private tap: Float32Array[] = [];
  private tapped = 0;

  /** `ask` tells who sends sound what is wanted. */
  constructor(private readonly ask: (wishes: AudioWish[]) => void) {
    effect(() => {
      const loud = this.muted.value ? 0 : this.volume.value;
      if (this.gain && this.context) this.gain.gain.setTargetAtTime(loud, this.context.currentTime, 0.02);
    });
    probe("audio", () => ({
      path: this.output?.kind ?? null,
      rate: this.context?.sampleRate ?? 0,
      state: this.context?.state ?? "none",
      time: this.context?.currentTime ?? 0,
      latency: this.latency.peek(),
      blocks: this.blocks,
      tapped: this.tapped,
      report: this.report,
    }));
    probe("tap", () => this.tap.flatMap((samples) => Array.from(samples)));
    probe("clearTap", () => {
      this.tap = [];
      this.tapped = 0;
    });
  }

  listen(wish: AudioWish): void {
    if (sameWish(wish, this.wish.value)) return;
    this.output?.flush();
    this.early = [];
    this.wish.value = wish;
    this.over.value = false;
    this.ask([wish]);
    // Made here, in the click that asked for it: browsers let nothing sound without one.
    void this.context?.resume();
  }

  stop(): void {
    this.output?.flush();
    this.early = [];
    this.wish.value = null;
    this.latency.value = null;
    this.over.value = false;
    this.ask([]);
  }

  /** Hops begin anew, or nobody sends any more: samples count from 0 again. */
  restart(): void {
    this.output?.flush();
    this.early = [];
    this.latency.value = null;
    if (this.wish.value?.track !== undefined) this.stop();
  }

  push(block: AudioBlock): void {
    const wish = this.wish.value;
    if (!wish || block.stream !== wish.stream || block.source !== (wish.track ?? wish.mic)) return;
    if (!this.context || this.context.sampleRate !== block.rate) this.open(block.rate);
    this.blocks++;
    if (this.output) this.play(block);
    else if (this.early.length < 64) this.early.push(block);
  }

  /** After a click: the browser lets it sound now. */
  unblock(): void {
    void this.context?.resume().then(() => {
      this.blocked.value = false;
    });
  }

  close(): void {
    this.stop();
    this.output?.close();
    void this.context?.close();
    this.context = null;
    this.output = null;
  }

  private play(block: AudioBlock): void {
    const samples = new Float32Array(block.samples.length);
    for (let k = 0; k < samples.length; k++) samples[k] = block.samples[k]! / 32768;
    this.output!.push(samples, block.first, block.last);
    if (block.last) this.over.value = true;
  }

  private open(rate: number): void {
    if (this.making && this.context?.sampleRate === rate) return;
    this.output?.close();
    this.output = null;
    void this.context?.close();
    const context = new AudioContext({ sampleRate: rate, latencyHint: "interactive" });
    this.context = context;
    this.gain = context.createGain();
    this.gain.gain.value = this.muted.value ? 0 : this.volume.value;
    this.analyser = context.createAnalyser();
    this.analyser.smoothingTimeConstant = 0;
    this.gain.connect(this.analyser).connect(context.destination);
    context.onstatechange = () => {
      this.blocked.value = context.state === "suspended";
    };
    this.blocked.value = context.state === "suspended";
    this.making = makeOutput(context, this.gain, { report: (report) => this.take(report), tap: testing ? (samples) => this.keep(samples) : null }).then((output) => {
      if (this.context !== context) return output.close();
      this.output = output;
      for (const block of this.early.splice(0)) this.play(block);
    });
  }

  private take(report: JitterReport): void {
    this.report = report;
    this.underruns.value = report.underruns;
    const context = this.context;
    if (!context || this.wish.peek() === null) return;
    const device = (context.outputLatency || 0) + context.baseLatency;
    this.latency.value = report.playing ? Math.round(1000 * (report.waiting + device)) : null;
  }

  private keep(samples: Float32Array): void {
    if (this.tapped >= kTapMost || !this.wish.peek()) return;
    this.tap.push(samples.slice());
    this.tapped += samples.length;
  }
}
