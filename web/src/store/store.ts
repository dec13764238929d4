// SPDX-License-Identifier: MIT
// What the page knows. One store for the daemon, another one for a replay: both are fed with the same messages.
import { batch, computed, signal } from "@preact/signals";

import type { PowerMap } from "../socket/binary";
import type {
  ActiveRecording,
  Beams,
  Engine,
  Happening,
  Health,
  Hello,
  Hops,
  LogLine,
  Message,
  Meters,
  Run,
  Target,
  Transcript,
} from "../socket/messages";
import { kProtocol } from "../socket/messages";
import { HopRing } from "./hops";
import { TrackTable, type Track } from "./tracks";

/** `live`: hops come. `stale`: none for a second. `offline`: no connection. `still`: connected, and the engine does not run. */
export type Link = "connecting" | "live" | "stale" | "offline" | "still";

/** What separation says of a voice, dB. */
export interface Beam {
  snr: number | null;
  gain: number | null;
  condition: number | null;
}

const kLogLines = 400;
const kSlots = 4;
const kPotentials = 4;

/** Seconds without a hop after which what is shown is no longer true. */
export const kStale = 1;

export class Store {
  readonly connected = signal(false);
  readonly attempts = signal(0);
  readonly hello = signal<Hello | null>(null);
  readonly run = computed<Run | null>(() => this.hello.value?.run ?? null);
  readonly engine = signal<Engine | null>(null);
  readonly stale = signal(false);
  readonly health = signal<Health | null>(null);
  readonly meters = signal<Meters | null>(null);
  /** By track. */
  readonly beams = signal<ReadonlyMap<number, Beam>>(new Map());
  readonly log = signal<LogLine[]>([]);
  readonly recording = signal<ActiveRecording[]>([]);
  readonly diskFree = signal<number | null>(null);
  /** Raised by each message that says that the list of recordings is another one. */
  readonly recordingsChanged = signal(0);
  readonly transcripts = signal<ReadonlyMap<number, Transcript[]>>(new Map());
  readonly lastEvent = signal<Happening | null>(null);
  readonly targets = signal<Target[]>([]);
  readonly power = signal<PowerMap | null>(null);
  /** Hops that this client or the page has missed in this run. */
  readonly missed = signal(0);
  /** Hops a second that arrive. */
  readonly pace = signal(0);
  /** Raised by every batch of hops: what draws looks at `ring` and `tracks` then. */
  readonly beat = signal(0);
  /** Raised when hops begin anew after others. */
  readonly epoch = signal(0);

  /** Not signals: they change 125 times a second. */
  ring = new HopRing(kSlots, kPotentials, 16000, 128);
  readonly tracks = new TrackTable();

  readonly link = computed<Link>(() => {
    if (!this.connected.value) return this.attempts.value === 0 ? "connecting" : "offline";
    const state = this.engine.value?.state;
    if (this.run.value === null || (state !== undefined && state !== "running")) return "still";
    return this.stale.value ? "stale" : "live";
  });

  readonly operator = computed(() => (this.hello.value?.role ?? "operator") === "operator");

  /** Why not everything can be shown; null when this daemon and this page know each other. */
  readonly stranger = computed<"newer" | "older" | null>(() => {
    const hello = this.hello.value;
    if (!hello) return null;
    if (hello.protocol === undefined || hello.protocol < kProtocol) return "older";
    return hello.protocol > kProtocol ? "newer" : null;
  });

  private runKey = "";
  private lastHopAt = 0;
  private paceFrom = 0;
  private paceHops = 0;

  can(capability: string): boolean {
    const all = this.hello.value?.capabilities;
    return all === undefined || all.includes(capability);
  }

  /** Seconds of the run at the newest hop. */
  get now(): number {
    return this.ring.end > 0 ? this.ring.time(this.ring.end - 1) : 0;
  }

  liveTracks(): Track[] {
    return [...this.tracks.live.values()].sort((a, b) => a.id - b.id);
  }

  receive(message: Message, at = performance.now()): void {
    batch(() => this.take(message, at));
  }

  receivePower(map: PowerMap): void {
    this.power.value = map;
  }

  /** Called a few times a second: nothing arrives to tell us that nothing arrives. */
  tick(at = performance.now()): void {
    const silent = (at - this.lastHopAt) / 1000;
    this.stale.value = silent > kStale;
    if (silent > kStale) this.pace.value = 0;
    if (silent > 3 && this.tracks.live.size > 0) this.endTracks();
  }

  disconnected(): void {
    batch(() => {
      this.connected.value = false;
      this.meters.value = null;
      this.power.value = null;
      this.beams.value = new Map();
      this.recording.value = [];
      this.pace.value = 0;
      this.endTracks();
    });
  }

  private take(message: Message, at: number): void {
    switch (message.type) {
      case "hello":
        return this.greet(message, at);
      case "hops":
        return this.hear(message, at);
      case "gap":
        this.missed.value += message.hops ?? 0;
        return;
      case "meters":
        this.meters.value = message;
        return;
      case "beams":
        this.beams.value = beamsOf(message);
        return;
      case "health":
        this.health.value = message;
        return;
      case "engine":
        this.engine.value = message;
        if (message.state !== "running") this.endTracks();
        else this.lastHopAt = at;
        return;
      case "log":
        this.log.value = [...this.log.value, ...message.lines].slice(-kLogLines);
        return;
      case "recordings":
        this.recording.value = message.active ?? [];
        this.diskFree.value = message.disk_free ?? this.diskFree.value;
        this.recordingsChanged.value++;
        return;
      case "transcript":
        this.transcripts.value = withTranscript(this.transcripts.value, message);
        return;
      case "event":
        this.lastEvent.value = message;
        return;
      case "targets":
        this.targets.value = message.targets ?? [];
        return;
      default:
        return;
    }
  }

  private greet(hello: Hello, at: number): void {
    this.hello.value = hello;
    this.connected.value = true;
    this.attempts.value = 0;
    const run = hello.run ?? null;
    const key = run ? `${run.id} ${run.start ?? ""} ${run.config_hash ?? ""}` : "";
    if (key !== this.runKey) {
      this.runKey = key;
      this.begin(run);
    }
    this.targets.value = run?.targets ?? [];
    this.lastHopAt = at;
    this.stale.value = false;
  }

  /** Hops begin anew: nothing of the run before may be seen any more. */
  private begin(run: Run | null): void {
    const rate = run?.rate && run.rate > 0 ? run.rate : 16000;
    const hop = run?.hop && run.hop > 0 ? run.hop : 128;
    const anew = this.ring.end > 0;
    this.ring = new HopRing(run?.slots ?? kSlots, run?.potentials ?? kPotentials, rate, hop);
    this.tracks.clear();
    this.meters.value = null;
    this.power.value = null;
    this.beams.value = new Map();
    this.health.value = null;
    this.transcripts.value = new Map();
    this.missed.value = 0;
    if (anew) this.epoch.value++;
    this.beat.value++;
  }

  private hear(message: Hops, at: number): void {
    const run = this.run.value;
    if (message.run !== undefined && run && message.run !== run.id) return;
    for (const hop of message.hops ?? []) {
      const now = hop.t * this.ring.period;
      if (this.ring.end > 0 && now <= this.now) this.begin(run);
      this.ring.push(hop);
      this.tracks.push(hop, now);
    }
    this.lastHopAt = at;
    this.stale.value = false;
    if (this.paceFrom === 0) this.paceFrom = at;
    else this.paceHops += message.hops?.length ?? 0;
    if (at - this.paceFrom >= 1000) {
      this.pace.value = Math.round((this.paceHops * 1000) / (at - this.paceFrom));
      this.paceFrom = at;
      this.paceHops = 0;
    }
    this.beat.value++;
  }

  private endTracks(): void {
    this.tracks.endAll(this.now);
    this.beat.value++;
  }
}

function beamsOf(message: Beams): ReadonlyMap<number, Beam> {
  return new Map((message.beams ?? []).map(([, track, snr = null, gain = null, condition = null]) => [track, { snr, gain, condition }]));
}

/** Final texts stay; one that is not final gives way to the next. The last eight of each track are kept. */
function withTranscript(all: ReadonlyMap<number, Transcript[]>, next: Transcript): ReadonlyMap<number, Transcript[]> {
  const mine = (all.get(next.track) ?? []).filter((one) => one.final);
  const result = new Map(all);
  result.set(next.track, [...mine, next].slice(-8));
  return result;
}
