// SPDX-License-Identifier: MIT
// Feeds the hops of a session as a daemon would: every hop once and in order, at any speed, from anywhere, in a loop.
import type { Run, WireHop } from "../socket/messages";
import { partAt, type Part, type Session } from "./session";

/** Where the hops go: the store of the Live page. */
export interface Feed {
  begin(run: Run): void;
  hops(hops: WireHop[]): void;
}

/** What is shown of the past after a jump, seconds. */
const kHistory = 60;

export const kSpeeds = [0.25, 0.5, 1, 2, 4, 8];

export class Replayer {
  private fed = 0;
  private part: Part | undefined;
  private now = 0;
  speed = 1;
  /** Seconds; `b` at the end where there is none. */
  loop: { a: number; b: number } | null = null;

  constructor(
    readonly session: Session,
    private readonly feed: Feed,
  ) {
    this.seek(0);
  }

  /** Seconds since the session began. */
  get position(): number {
    return this.now;
  }

  get ended(): boolean {
    return this.now >= this.session.seconds;
  }

  seek(seconds: number): void {
    this.now = Math.min(Math.max(seconds, 0), this.session.seconds);
    const { hops } = this.session;
    const until = hops.countUntil(this.now);
    this.part = undefined;
    this.fed = Math.min(hops.countUntil(this.now - kHistory), until);
    const part = partAt(this.session, this.now);
    if (part) this.fed = Math.max(this.fed, Math.min(part.firstHop, until));
    this.feedUntil(until);
  }

  /** `elapsed` seconds of the watcher have gone by. False: it jumped, or has come to the end. */
  advance(elapsed: number): boolean {
    const next = this.now + elapsed * this.speed;
    if (this.loop && this.now < this.loop.b && next >= this.loop.b) {
      this.seek(this.loop.a);
      return false;
    }
    this.now = Math.min(next, this.session.seconds);
    this.feedUntil(this.session.hops.countUntil(this.now));
    return !this.ended;
  }

  /** To the next or the last hop: -1, 1. */
  step(by: number): void {
    const { hops } = this.session;
    if (hops.length === 0) return;
    const index = Math.min(Math.max(hops.countUntil(this.now) - 1 + by, 0), hops.length - 1);
    if (by > 0) {
      this.now = Math.max(hops.seconds(index), this.now);
      this.feedUntil(index + 1);
    } else {
      this.seek(hops.seconds(index));
    }
  }

  private feedUntil(end: number): void {
    const { hops, parts } = this.session;
    while (this.fed < end) {
      const part = parts.findLast((one) => one.firstHop <= this.fed)!;
      const next = parts.find((one) => one.firstHop > this.fed)?.firstHop ?? hops.length;
      if (part !== this.part) this.feed.begin(part.run);
      this.part = part;
      const batch: WireHop[] = [];
      for (; this.fed < Math.min(end, next); ++this.fed) batch.push(hops.at(this.fed));
      this.feed.hops(batch);
    }
    if (!this.part && parts[0]) {
      this.part = partAt(this.session, this.now);
      if (this.part) this.feed.begin(this.part.run);
    }
  }
}
