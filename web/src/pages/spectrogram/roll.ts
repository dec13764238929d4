// SPDX-License-Identifier: MIT
// Columns of levels that roll to the left: a picture of the last seconds, one byte a bin.
import type { AudioBlock } from "../../socket/binary";
import { Spectrum } from "../../lib/spectrum";

const kLow = -110;
const kHigh = 0;

export class Roll {
  private spectrum = new Spectrum();
  readonly bins = this.spectrum.bins;
  /** Level of bin b in column c at `c * bins + b`: 0 is -110 dB or less, 255 is 0 dB. */
  readonly levels: Uint8Array;
  /** Columns that were ever written; the newest is at `(written - 1) % columns`. */
  written = 0;
  rate = 16000;
  /** The strongest bin of the newest column. */
  loudest = { bin: 0, level: kLow };
  private next = -1;
  private scaled = new Float32Array(0);

  constructor(readonly columns: number) {
    this.levels = new Uint8Array(columns * this.bins);
  }

  /** Seconds that the picture holds. */
  get seconds(): number {
    return (this.columns * this.spectrum.hop) / this.rate;
  }

  push({ samples, rate, first }: Pick<AudioBlock, "samples" | "rate" | "first">): void {
    this.rate = rate;
    if (this.next >= 0 && first !== this.next) this.bridge(first - this.next);
    this.next = first + samples.length;
    if (this.scaled.length < samples.length) this.scaled = new Float32Array(samples.length);
    for (let i = 0; i < samples.length; ++i) this.scaled[i] = samples[i]! / 32768;
    this.spectrum.push(this.scaled.subarray(0, samples.length), (levels) => this.take(levels));
  }

  clear(): void {
    this.levels.fill(0);
    this.written = 0;
    this.next = -1;
    this.spectrum.reset();
  }

  /** Sound that never came is dark, so that time goes on evenly. */
  private bridge(missing: number): void {
    this.spectrum.reset();
    const columns = Math.min(this.columns, Math.max(0, Math.round(missing / this.spectrum.hop)));
    for (let i = 0; i < columns; ++i) this.levels.fill(0, this.begin(), this.begin(this.written++) + this.bins);
  }

  private begin(column = this.written): number {
    return (column % this.columns) * this.bins;
  }

  private take(levels: Float32Array): void {
    const at = this.begin();
    let best = 1;
    for (let bin = 0; bin < this.bins; ++bin) {
      if (bin > 0 && levels[bin]! > levels[best]!) best = bin;
      this.levels[at + bin] = Math.round((255 * (Math.min(Math.max(levels[bin]!, kLow), kHigh) - kLow)) / (kHigh - kLow));
    }
    this.loudest = { bin: best, level: levels[best]! };
    ++this.written;
  }
}

/** The byte of `levels` for a level in dB. */
export function byteOf(decibels: number): number {
  return (255 * (decibels - kLow)) / (kHigh - kLow);
}
