// SPDX-License-Identifier: MIT
// A recorded session: what docs/protocol.md, "Session files", says is in the file, ready to be shown again.
import { parseBinary } from "../socket/binary";
import type { Happening, LogLine, Run, StreamName, Transcript, WireHop } from "../socket/messages";
import { HopStore } from "./hop_store";
import { readMcap, type McapFault, type McapMessage } from "./mcap";
import { SoundIndex } from "./sound_index";

/** One engine run within the session: hops of another one begin anew. */
export interface Part {
  run: Run;
  /** Index of its first hop. */
  firstHop: number;
  /** Time stamp of its first hop. */
  firstStamp: number;
  /** Seconds since the session's beginning. */
  from: number;
}

/** When a track was there. */
export interface TrackSpan {
  id: number;
  from: number;
  to: number;
  tag?: string;
  /** The class it had most: 0 undefined, 1 no speech, 2 speech. */
  kind: number;
}

export interface At<T> {
  seconds: number;
  what: T;
}

export interface Session {
  name: string;
  file: Blob;
  parts: Part[];
  hops: HopStore;
  spans: TrackSpan[];
  sound: SoundIndex;
  log: At<LogLine>[];
  events: At<Happening>[];
  transcripts: At<Transcript>[];
  /** From the first hop to the end of the last. */
  seconds: number;
  /** UTC, milliseconds since 1970, of the first hop. */
  start: number;
  fault: McapFault | null;
  /** Messages that could not be understood and were left out. */
  unread: number;
}

/** Reads a session; `fault` says if its end is missing. A file without a single hop has `hops.length` 0. */
export async function readSession(name: string, file: Blob, progress?: (share: number) => void): Promise<Session> {
  const builder = new Builder(name, file);
  const end = await readMcap(file, (message) => builder.take(message), progress);
  return builder.finish(end.fault);
}

class Builder {
  private readonly session: Session;
  private readonly spans = new Map<string, TrackSpan & { votes: number[] }>();
  private run: Run | null = null;
  private origin: bigint | null = null;

  constructor(name: string, file: Blob) {
    this.session = {
      name, file, parts: [], hops: new HopStore(), spans: [], sound: new SoundIndex(),
      log: [], events: [], transcripts: [], seconds: 0, start: 0, fault: null, unread: 0,
    };
  }

  take(message: McapMessage): void {
    try {
      if (message.topic.startsWith("audio/")) this.takeAudio(message);
      else this.takeJson(message);
    } catch {
      ++this.session.unread;
    }
  }

  finish(fault: McapFault | null): Session {
    const { session } = this;
    session.fault = fault;
    session.spans = [...this.spans.values()].map(({ votes, ...span }) => ({ ...span, kind: votes.indexOf(Math.max(...votes)) }));
    return session;
  }

  private takeJson({ topic, data, logTime }: McapMessage): void {
    if (topic === "run") {
      this.run = decode<Run>(data);
    } else if (topic === "hops") {
      this.takeHop(data, decode<WireHop>(data), logTime);
    } else if (topic === "log") {
      for (const line of linesOf(decode(data))) this.session.log.push({ seconds: this.since(logTime), what: line });
    } else if (topic === "event") {
      this.session.events.push({ seconds: this.since(logTime), what: decode<Happening>(data) });
    } else if (topic === "transcript") {
      this.session.transcripts.push({ seconds: this.since(logTime), what: decode<Transcript>(data) });
    }
  }

  private takeHop(data: Uint8Array, hop: WireHop, logTime: bigint): void {
    const { session, run } = this;
    if (!run) throw new Error("a hop before its run");
    if (this.origin === null) {
      this.origin = logTime;
      session.start = Number(logTime / 1000000n);
    }
    let part = session.parts.at(-1);
    if (!part || part.run !== run) {
      part = { run, firstHop: session.hops.length, firstStamp: hop.t, from: Math.max(this.since(logTime), session.seconds) };
      session.parts.push(part);
    }
    const step = run.hop / run.rate;
    const seconds = part.from + (hop.t - part.firstStamp) * step;
    session.hops.push(data, seconds);
    session.seconds = seconds + step;
    for (const [, id, , , , , , kind = 0, tag] of hop.tracks ?? []) this.note(session.parts.length, id, seconds, step, kind, tag);
  }

  private note(part: number, id: number, seconds: number, step: number, kind: number, tag: string | undefined): void {
    const key = `${part}/${id}`;
    let span = this.spans.get(key);
    if (!span) {
      span = { id, from: seconds, to: seconds, kind: 0, votes: [0, 0, 0], ...(tag ? { tag } : {}) };
      this.spans.set(key, span);
    }
    span.to = seconds + step;
    if (kind in span.votes) ++span.votes[kind]!;
  }

  private takeAudio({ topic, data, offset }: McapMessage): void {
    const head = parseBinary(data.slice().buffer);
    if (head?.kind !== "audio") throw new Error("no sound");
    this.session.sound.add(topic.slice("audio/".length) as StreamName, this.session.parts.length - 1, head, offset);
  }

  private since(logTime: bigint): number {
    return this.origin === null ? 0 : Number(logTime - this.origin) / 1e9;
  }
}

function decode<T>(data: Uint8Array): T {
  return JSON.parse(new TextDecoder().decode(data)) as T;
}

function linesOf(message: { lines?: LogLine[] } & Partial<LogLine>): LogLine[] {
  return message.lines ?? (message.text === undefined ? [] : [message as LogLine]);
}

/** The part that is playing at `seconds`. */
export function partAt(session: Session, seconds: number): Part | undefined {
  return session.parts.findLast((part) => part.from <= seconds) ?? session.parts[0];
}
