// SPDX-License-Identifier: MIT
// What the daemon says (docs/protocol.md, "The Studio"). Everything but `type` may be missing: daemons are older or newer.

export type Vec3 = [number, number, number];

/** The protocol that this page was written for. */
export const kProtocol = 1;

export interface Mic {
  position: Vec3;
  direction?: Vec3;
  /** Of the sound card, from 1. */
  channel?: number;
}

export interface Target {
  tag: string;
  direction: Vec3;
  mute?: boolean;
}

export interface Run {
  id: number;
  name?: string;
  source?: string;
  kind?: "live" | "recording" | "odas" | "replay";
  /** Hz */
  rate: number;
  /** Samples */
  hop: number;
  slots?: number;
  potentials?: number;
  /** Seconds that a recording can begin before it was asked for. */
  lookback?: number;
  voice_delay?: number;
  start?: string;
  config_hash?: string;
  mics?: Mic[];
  power_grid?: Vec3[];
  targets?: Target[];
}

export interface Camera {
  url?: string;
  [key: string]: unknown;
}

export interface Hello {
  type: "hello";
  protocol?: number;
  server?: string;
  role?: "operator" | "viewer";
  capabilities?: string[];
  recordings?: string | null;
  open_session?: string | null;
  camera?: Camera | null;
  run?: Run | null;
}

/** [slot, id, x, y, z, activity, level in dB or null, class, tag] */
export type WireTrack = [number, number, number, number, number, number, (number | null)?, number?, string?];

export interface WireHop {
  t: number;
  tracks?: WireTrack[];
  potentials?: [number, number, number, number][];
}

export interface Hops {
  type: "hops";
  run?: number;
  hops: WireHop[];
}

export interface Gap {
  type: "gap";
  run?: number;
  hops?: number;
}

export const MicFlag = { clipped: 1, dead: 2, duplicate: 4 } as const;

export interface Meters {
  type: "meters";
  t?: number;
  /** [RMS in dB, peak in dB, flags, the microphone that this one equals, from 1] */
  mics: [number | null, number | null, number?, number?][];
}

/** Decibels; null: the method of separation does not know. */
export interface Beams {
  type: "beams";
  run?: number;
  t?: number;
  /** [slot, track, SNR, white-noise gain, condition] */
  beams: [number, number, (number | null)?, (number | null)?, (number | null)?][];
}

export interface Health {
  type: "health";
  hops?: number;
  hop_p50_us?: number;
  hop_p99_us?: number;
  hop_max_us?: number;
  real_time_share?: number;
  dropped_hops?: number;
  lost_records?: number;
  overruns?: number;
  lost_frames?: number;
  clipped_samples?: number;
  cpu?: number;
  rss_bytes?: number;
  temperature?: number | null;
  clients?: number;
  client_dropped?: number;
  latency?: number;
  stages?: [string, number][];
}

export type EngineState = "idle" | "starting" | "running" | "waiting" | "stopped" | "failed" | "ended";

export interface Engine {
  type: "engine";
  state: EngineState;
  what?: string;
}

export interface LogLine {
  at?: string;
  level?: string;
  text: string;
}

export interface Log {
  type: "log";
  lines: LogLine[];
}

export interface ActiveRecording {
  id: number | string;
  what: "track" | "raw" | "session" | "all";
  track?: number;
  name?: string;
  seconds?: number;
}

export interface Recordings {
  type: "recordings";
  active?: ActiveRecording[];
  disk_free?: number;
}

export interface Transcript {
  type: "transcript";
  track: number;
  text: string;
  final?: boolean;
  from?: number;
  to?: number;
}

export interface Happening {
  type: "event";
  event: "appear" | "disappear" | "class";
  track: number;
  direction?: Vec3;
  class?: number;
  at?: string;
}

export interface Targets {
  type: "targets";
  targets: Target[];
}

export interface RpcError {
  code: string;
  message: string;
  data?: unknown;
}

export interface Reply {
  type: "reply";
  id: number;
  result?: unknown;
  error?: RpcError;
}

export interface Pong {
  type: "pong";
  at?: unknown;
}

export type Message =
  | Hello
  | Hops
  | Gap
  | Meters
  | Beams
  | Health
  | Engine
  | Log
  | Recordings
  | Transcript
  | Happening
  | Targets
  | Reply
  | Pong;

export type StreamName = "separated" | "postfiltered" | "raw";

/** One stream of sound that a client wants. */
export interface AudioWish {
  stream: StreamName;
  track?: number;
  mic?: number;
}

export interface Topics {
  hops?: number;
  meters?: number;
  health?: number;
  log?: number;
  power?: number;
  beams?: number;
  recordings?: number;
  events?: number;
  transcripts?: number;
}
