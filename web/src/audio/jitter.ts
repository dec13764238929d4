// SPDX-License-Identifier: MIT
// Turns blocks that arrive unevenly into sound that flows evenly. Pure: the worklet and the scheduled buffers both play from it.

/** Seconds of sound that are kept waiting: at first, and at most when the way here is uneven. */
export const kTarget = 0.08;
export const kTargetMost = 0.15;

/** Seconds over which the least that waited is taken: more than that was never needed. */
const kWindow = 1;
/** Seconds by which that least may be above the target, or what share of the target it may fall to, before anything is done. */
const kSlack = 0.03;
const kLow = 0.4;
/** So many times in a row a small excess must be seen: on a busy computer what is too much now is needed in a moment. */
const kPatience = 5;
/** An excess of this much (seconds) is left out at once. */
const kCut = 0.06;
/** Share by which playing is faster or slower for a smaller one: not heard as another pitch. */
const kHaste = 0.004;
/** Beyond the target by this much (seconds) the oldest sound is left out: it would come too late. */
const kTooMuch = 0.25;
const kFade = 0.005;
/** A hole longer than this (seconds) is made this long. */
const kLongestHole = 0.5;

export interface JitterReport {
  /** Seconds that wait. */
  waiting: number;
  target: number;
  /** Times that nothing was there to play though there should have been. */
  underruns: number;
  /** Samples handed out, without silence for want of any. */
  played: number;
  /** Samples left out since they would have come too late. */
  skipped: number;
  /** Samples of silence in the place of those that are missing. */
  missing: number;
  playing: boolean;
  /** Index of the sample that is played next. */
  index: number;
}

export class JitterBuffer {
  private readonly ring: Float32Array;
  private readonly fade: number;
  private write = 0;
  private read = 0;
  private next = -1;
  private playing = false;
  private ended = false;
  private gain = 0;
  private last = 0;
  private tail: Float32Array = new Float32Array(0);
  private target = kTarget;
  private calm = 0;
  /** Samples that are still to be won (or, below 0, lost) by playing faster (slower). */
  private owed = 0;
  private least = Infinity;
  private excesses = 0;
  private window = 0;
  private underruns = 0;
  private played = 0;
  private skipped = 0;
  private missing = 0;

  constructor(private readonly rate: number) {
    this.ring = new Float32Array(Math.ceil(2 * rate));
    this.fade = Math.max(1, Math.round(kFade * rate));
  }

  /** `first` is the index of the first sample in its stream; `last`: no more will come. */
  push(samples: Float32Array, first: number, last = false): void {
    let from = 0;
    if (this.next >= 0 && first > this.next) this.pad(first - this.next);
    else if (this.next >= 0 && first < this.next) from = Math.min(samples.length, this.next - first);
    for (let k = from; k < samples.length; k++) this.put(samples[k]!);
    this.next = Math.max(this.next, first + samples.length);
    this.ended = last;
    const waiting = this.write - this.read;
    if (waiting > (this.target + kTooMuch) * this.rate) this.skip(waiting - Math.round(this.target * this.rate));
  }

  /** Another stream follows: what plays fades out, and nothing of it is heard later. */
  flush(): void {
    if (this.playing) {
      const count = Math.min(this.fade, Math.floor(this.write - this.read));
      this.tail = new Float32Array(this.fade);
      for (let k = 0; k < this.fade; k++) {
        const value = k < count ? this.at(Math.floor(this.read) + k) : this.last * (1 - k / this.fade);
        this.tail[k] = value * this.gain * (1 - (k + 1) / this.fade);
      }
    }
    this.read = this.write = 0;
    this.next = -1;
    this.playing = this.ended = false;
    this.gain = this.last = 0;
    this.watchAnew();
  }

  /** Fills `out` with what is to be heard now. */
  pull(out: Float32Array): void {
    const waiting = this.write - this.read;
    if (!this.playing && (waiting >= this.target * this.rate || (this.ended && waiting > 0))) this.begin();
    const step = 1 + Math.sign(this.owed) * kHaste;
    for (let k = 0; k < out.length; k++) out[k] = this.one(step) + this.leftOver();
    this.repay(out.length);
    this.watch(out.length);
    this.settle(out.length);
  }

  report(): JitterReport {
    return {
      waiting: (this.write - this.read) / this.rate,
      target: this.target,
      underruns: this.underruns,
      played: this.played,
      skipped: this.skipped,
      missing: this.missing,
      playing: this.playing,
      index: this.next - (this.write - this.read),
    };
  }

  /** What piled up before the first sample is heard is left out, so that playing begins at the target. */
  private begin(): void {
    const spare = this.write - this.read - Math.round(this.target * this.rate);
    if (spare > 0 && !this.ended) this.skip(spare);
    this.playing = true;
    this.gain = 0;
    this.watchAnew();
  }

  private one(step: number): number {
    if (!this.playing) return (this.last *= 0.97);
    if (this.write - this.read < 1) {
      this.playing = false;
      this.last *= this.gain;
      if (!this.ended) {
        this.underruns++;
        this.target = Math.min(kTargetMost, this.target + 0.02);
        this.calm = 0;
      }
      return (this.last *= 0.97);
    }
    const value = this.value(this.read);
    this.read += step;
    this.played++;
    this.last = value;
    this.gain = Math.min(1, this.gain + 1 / this.fade);
    return value * this.gain;
  }

  /** Whole positions are the samples themselves; between them a cubic (Catmull-Rom). */
  private value(position: number): number {
    const index = Math.floor(position);
    const f = position - index;
    if (f === 0) return this.at(index);
    const b = this.at(index);
    const a = index > 0 ? this.at(index - 1) : b;
    const c = index + 1 < this.write ? this.at(index + 1) : b;
    const d = index + 2 < this.write ? this.at(index + 2) : c;
    return b + 0.5 * f * (c - a + f * (2 * a - 5 * b + 4 * c - d + f * (3 * (b - c) + d - a)));
  }

  private repay(count: number): void {
    if (this.owed === 0) return;
    const left = Math.abs(this.owed) - count * kHaste;
    this.owed = left > 0 ? Math.sign(this.owed) * left : 0;
    if (this.owed === 0) this.read = Math.round(this.read);
  }

  /** Clocks differ, and what came late comes all at once: once a second it is seen how much waits for nothing, or is wanting. */
  private watch(count: number): void {
    if (!this.playing || this.ended) return this.watchAnew();
    this.least = Math.min(this.least, (this.write - this.read) / this.rate);
    this.window += count;
    if (this.window < kWindow * this.rate) return;
    const over = this.least - this.target;
    this.excesses = over > kSlack ? this.excesses + 1 : 0;
    if (over > kCut) this.cut(Math.round(over * this.rate));
    else if (this.excesses >= kPatience) this.owed = over * this.rate;
    else if (this.least < kLow * this.target) this.owed = (this.least - 0.5 * this.target) * this.rate;
    this.least = Infinity;
    this.window = 0;
  }

  private watchAnew(): void {
    this.owed = 0;
    this.excesses = 0;
    this.least = Infinity;
    this.window = 0;
  }

  /** Leaves samples out where they are played next; those before fade into those after. */
  private cut(count: number): void {
    const from = Math.floor(this.read);
    this.read = from + count;
    this.skipped += count;
    for (let k = 0; k < this.fade; k++) {
      const share = (k + 1) / (this.fade + 1);
      const place = (this.read + k) % this.ring.length;
      this.ring[place] = (1 - share) * this.at(from + k) + share * this.ring[place]!;
    }
    this.owed = 0;
  }

  /** After a minute without trouble less has to wait. */
  private settle(count: number): void {
    if (!this.playing) return;
    this.calm += count;
    if (this.calm > 60 * this.rate) {
      this.calm = 0;
      this.target = Math.max(kTarget, this.target - 0.01);
    }
  }

  private leftOver(): number {
    if (this.tail.length === 0) return 0;
    const value = this.tail[0]!;
    this.tail = this.tail.subarray(1);
    return value;
  }

  private at(index: number): number {
    return this.ring[index % this.ring.length]!;
  }

  private put(value: number): void {
    this.ring[this.write % this.ring.length] = value;
    this.write++;
    if (this.write - this.read > this.ring.length - 4) this.read = this.write - this.ring.length + 4;
  }

  private pad(count: number): void {
    const hole = Math.min(count, Math.round(kLongestHole * this.rate));
    this.missing += count;
    for (let k = 0; k < hole; k++) this.put(0);
  }

  private skip(count: number): void {
    this.read = Math.floor(this.read) + count;
    this.skipped += count;
    this.gain = 0;
    this.watchAnew();
  }
}
