// SPDX-License-Identifier: MIT
// The hops of the last ten minutes, every one of them, in typed arrays that are written round and round.
import type { WireHop } from "../socket/messages";
import { azimuth, elevation } from "./angles";

/** Seconds kept. */
export const kKept = 600;

/**
 * Hops are counted by `seq`, from 0 for the first that arrived; those in `[first, end)` are kept. Column `seq % capacity` holds
 * the hop; row `slot` of a column its track (`id` 0: none), row `k` its potential (`energy` NaN: none). Angles in degrees.
 */
export class HopRing {
  readonly capacity: number;
  readonly slots: number;
  readonly peaks: number;
  /** Seconds between two hops. */
  readonly period: number;
  end = 0;

  readonly t: Float64Array;
  readonly id: Uint32Array;
  readonly az: Float32Array;
  readonly el: Float32Array;
  readonly activity: Float32Array;
  /** dB of full scale; NaN: unknown. */
  readonly level: Float32Array;
  readonly peakAz: Float32Array;
  readonly peakEl: Float32Array;
  readonly energy: Float32Array;

  constructor(slots: number, peaks: number, rate: number, hop: number) {
    this.period = hop / rate;
    this.capacity = Math.max(1, Math.ceil(kKept / this.period));
    this.slots = Math.max(1, slots);
    this.peaks = Math.max(0, peaks);
    const cells = this.capacity * this.slots;
    this.t = new Float64Array(this.capacity);
    this.id = new Uint32Array(cells);
    this.az = new Float32Array(cells);
    this.el = new Float32Array(cells);
    this.activity = new Float32Array(cells);
    this.level = new Float32Array(cells);
    this.peakAz = new Float32Array(this.capacity * this.peaks);
    this.peakEl = new Float32Array(this.capacity * this.peaks);
    this.energy = new Float32Array(this.capacity * this.peaks);
  }

  get first(): number {
    return Math.max(0, this.end - this.capacity);
  }

  /** Index of row `slot` at `seq` in the arrays of tracks. */
  cell(seq: number, slot: number): number {
    return (seq % this.capacity) * this.slots + slot;
  }

  /** The same in the arrays of potentials. */
  peak(seq: number, k: number): number {
    return (seq % this.capacity) * this.peaks + k;
  }

  /** Seconds of the hop since the start of the run. */
  time(seq: number): number {
    return this.t[seq % this.capacity]! * this.period;
  }

  /** The first kept hop at or after `seconds`; `end` where there is none. */
  at(seconds: number): number {
    let low = this.first;
    let high = this.end;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.time(middle) < seconds) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  push(hop: WireHop): void {
    const column = this.end % this.capacity;
    this.t[column] = hop.t;
    const base = column * this.slots;
    this.id.fill(0, base, base + this.slots);
    for (const [slot, id, x, y, z, activity, level] of hop.tracks ?? []) {
      if (!(slot >= 0 && slot < this.slots)) continue;
      const cell = base + slot;
      this.id[cell] = id;
      this.az[cell] = azimuth(x, y);
      this.el[cell] = elevation(x, y, z);
      this.activity[cell] = activity;
      this.level[cell] = level ?? NaN;
    }
    const peakBase = column * this.peaks;
    this.energy.fill(NaN, peakBase, peakBase + this.peaks);
    const potentials = hop.potentials ?? [];
    for (let k = 0; k < Math.min(this.peaks, potentials.length); k++) {
      const [x, y, z, energy] = potentials[k]!;
      this.peakAz[peakBase + k] = azimuth(x, y);
      this.peakEl[peakBase + k] = elevation(x, y, z);
      this.energy[peakBase + k] = energy;
    }
    this.end++;
  }
}
