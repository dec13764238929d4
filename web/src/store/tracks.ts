// SPDX-License-Identifier: MIT
// The voices of now: who is there, since when, where, and what they said.
import type { WireHop } from "../socket/messages";
import { azimuth, elevation } from "./angles";
import { LookAllocator, lookOf, type Look } from "./colors";

export interface Track {
  id: number;
  slot: number;
  tag: string;
  look: Look;
  /** Seconds of the run at which it was first and last seen. */
  born: number;
  seen: number;
  x: number;
  y: number;
  z: number;
  /** Degrees. */
  az: number;
  el: number;
  activity: number;
  /** dB of full scale; null: unknown. */
  level: number | null;
  /** 0 undefined, 1 no speech, 2 speech. */
  category: number;
}

/** A track that is away for this long (seconds) has ended, even if its id comes again in the next hop. */
const kAway = 0.5;

export class TrackTable {
  readonly live = new Map<number, Track>();
  /** Everyone who can still be seen in the charts, as he was last, by id. */
  readonly known = new Map<number, Track>();
  private readonly allocator = new LookAllocator();

  push(hop: WireHop, now: number): void {
    for (const [slot, id, x, y, z, activity, level, category, tag] of hop.tracks ?? []) {
      if (!id) continue;
      let track = this.live.get(id);
      if (!track) {
        const look = lookOf(this.allocator.of(id, now));
        track = { id, slot, tag: tag ?? "dynamic", look, born: now, seen: now, x, y, z, az: 0, el: 0, activity, level: null, category: 0 };
        this.live.set(id, track);
        this.known.set(id, track);
      }
      Object.assign(track, { slot, x, y, z, activity, level: level ?? null, category: category ?? 0, seen: now });
      track.az = azimuth(x, y);
      track.el = elevation(x, y, z);
    }
    for (const track of this.live.values()) if (now - track.seen > kAway) this.end(track.id, now);
  }

  /** The look of a track of the past ten minutes. */
  lookOf(id: number): Look {
    return this.known.get(id)?.look ?? lookOf(id);
  }

  /** Nobody is known to be there any more; looks stay for what the charts still show. */
  endAll(now: number): void {
    for (const id of [...this.live.keys()]) this.end(id, now);
  }

  clear(): void {
    this.live.clear();
    this.known.clear();
    this.allocator.clear();
  }

  private end(id: number, now: number): void {
    this.live.delete(id);
    this.allocator.release(id, now);
    if (this.known.size > 4096) this.forget();
  }

  private forget(): void {
    for (const id of this.known.keys()) {
      if (this.known.size <= 2048) return;
      if (!this.live.has(id)) this.known.delete(id);
    }
  }
}
