// SPDX-License-Identifier: MIT
// What the buttons of a replay do: a clock in the browser's frames, over the replayer and its sound.
import { signal } from "@preact/signals";

import { kSpeeds, Replayer, type Feed } from "../../lib/replayer";
import type { Session } from "../../lib/session";
import type { StreamName } from "../../socket/messages";
import { partAt } from "../../lib/session";
import { Sounding } from "./sounding";

interface Choice {
  key: string;
  stream: StreamName;
  source: number;
}

export class Playback {
  readonly position = signal(0);
  readonly playing = signal(false);
  readonly speed = signal(1);
  readonly loop = signal<{ a: number; b: number } | null>(null);
  readonly looping = signal(false);
  readonly voiceKey = signal("");
  /** What can be heard: a voice may be in several runs of the session. */
  readonly voices: Choice[];

  private readonly replayer: Replayer;
  private readonly sounding: Sounding;
  private frame = 0;
  private before = 0;

  constructor(
    private readonly session: Session,
    feed: Feed,
  ) {
    this.replayer = new Replayer(session, feed);
    this.sounding = new Sounding(session);
    const all = session.sound.list().map(({ stream, source }) => ({ key: `${stream}/${source}`, stream, source }));
    this.voices = [...new Map(all.map((choice) => [choice.key, choice])).values()];
  }

  toggle(): void {
    if (this.playing.value) return this.pause();
    if (this.replayer.ended) this.seek(0);
    this.playing.value = true;
    this.before = performance.now();
    this.frame = requestAnimationFrame(() => this.tick());
  }

  pause(): void {
    this.playing.value = false;
    cancelAnimationFrame(this.frame);
    this.sounding.silence();
  }

  seek(seconds: number): void {
    this.replayer.seek(seconds);
    this.look();
  }

  step(by: number): void {
    this.pause();
    this.replayer.step(by);
    this.look();
  }

  setSpeed(speed: number): void {
    this.speed.value = this.replayer.speed = speed;
  }

  faster(by: number): void {
    const index = kSpeeds.indexOf(this.speed.value);
    this.setSpeed(kSpeeds[Math.min(Math.max(index + by, 0), kSpeeds.length - 1)]!);
  }

  mark(which: "a" | "b"): void {
    const old = this.loop.value ?? { a: 0, b: this.session.seconds };
    const next = { ...old, [which]: this.position.value };
    if (next.a >= next.b) which === "a" ? (next.b = this.session.seconds) : (next.a = 0);
    this.loop.value = next;
    this.looping.value = true;
    this.applyLoop();
  }

  toggleLoop(): void {
    this.looping.value = !this.looping.value;
    this.applyLoop();
  }

  clearLoop(): void {
    this.loop.value = null;
    this.looping.value = false;
    this.applyLoop();
  }

  choose(key: string): void {
    this.voiceKey.value = key;
    this.sounding.silence();
  }

  close(): void {
    this.pause();
    this.sounding.close();
  }

  private applyLoop(): void {
    this.replayer.loop = this.looping.value ? (this.loop.value ?? { a: 0, b: this.session.seconds }) : null;
  }

  private tick(): void {
    if (!this.playing.value) return;
    // Not the time of the frame, which may be over for long on a busy computer: sound is heard now.
    const now = performance.now();
    // A tab that was hidden does not run through all that it missed.
    const elapsed = Math.min((now - this.before) / 1000, 0.5);
    this.before = now;
    this.replayer.advance(Math.max(0, elapsed));
    this.look();
    if (this.replayer.ended) return this.pause();
    this.sounding.voice = this.voiceOf(this.voiceKey.value);
    this.sounding.follow(this.position.value, this.speed.value);
    this.frame = requestAnimationFrame(() => this.tick());
  }

  private voiceOf(key: string) {
    const part = partAt(this.session, this.position.value);
    return this.session.sound.list().find((voice) => `${voice.stream}/${voice.source}` === key && this.session.parts[voice.part] === part) ?? null;
  }

  private look(): void {
    this.position.value = this.replayer.position;
  }
}
