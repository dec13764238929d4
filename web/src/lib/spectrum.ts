// SPDX-License-Identifier: MIT
// Sound that comes in blocks, as columns of levels over frequency.
import { Fft } from "./fft";

export class Spectrum {
  readonly bins: number;
  private readonly fft: Fft;
  private readonly window: Float64Array;
  private readonly held: Float64Array;
  private readonly re: Float64Array;
  private readonly im: Float64Array;
  private readonly result: Float32Array;
  private filled = 0;
  private readonly scale: number;

  /** Frames of `size` samples, `hop` apart. */
  constructor(readonly size = 512, readonly hop = 256) {
    this.fft = new Fft(size);
    this.bins = size / 2 + 1;
    this.window = Float64Array.from({ length: size }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size));
    this.held = new Float64Array(size);
    this.re = new Float64Array(size);
    this.im = new Float64Array(size);
    this.result = new Float32Array(this.bins);
    // A sine of full scale is 0 dB: its window's sum is size/2, half of it in the positive frequency.
    this.scale = 4 / size;
  }

  /** Calls `column` with dB of full scale for each bin, once a hop; the array is used again. Samples are -1..1. */
  push(samples: ArrayLike<number>, column: (levels: Float32Array) => void, gain = 1): void {
    for (let i = 0; i < samples.length; ++i) {
      this.held[this.filled++] = samples[i]! * gain;
      if (this.filled < this.size) continue;
      column(this.levels());
      this.held.copyWithin(0, this.hop);
      this.filled = this.size - this.hop;
    }
  }

  reset(): void {
    this.filled = 0;
  }

  private levels(): Float32Array {
    const levels = this.result;
    for (let i = 0; i < this.size; ++i) {
      this.re[i] = this.held[i]! * this.window[i]!;
      this.im[i] = 0;
    }
    this.fft.transform(this.re, this.im);
    for (let k = 0; k < this.bins; ++k) {
      levels[k] = 20 * Math.log10(Math.hypot(this.re[k]!, this.im[k]!) * this.scale + 1e-7);
    }
    return levels;
  }
}
