// SPDX-License-Identifier: MIT
// All hops of a session: kept as their bytes, which is a tenth of their objects, and read when they are wanted.
import type { WireHop } from "../socket/messages";

const kBlock = 1 << 20;

export class HopStore {
  private readonly blocks: Uint8Array[] = [];
  private used = kBlock;
  private where: { block: number; from: number; to: number; seconds: number }[] = [];

  get length(): number {
    return this.where.length;
  }

  /** `seconds` since the session began; never less than that of the hop before. */
  push(json: Uint8Array, seconds: number): void {
    if (this.used + json.length > kBlock) {
      this.blocks.push(new Uint8Array(Math.max(kBlock, json.length)));
      this.used = 0;
    }
    this.blocks[this.blocks.length - 1]!.set(json, this.used);
    this.where.push({ block: this.blocks.length - 1, from: this.used, to: this.used + json.length, seconds });
    this.used += json.length;
  }

  at(index: number): WireHop {
    const { block, from, to } = this.where[index]!;
    return JSON.parse(new TextDecoder().decode(this.blocks[block]!.subarray(from, to))) as WireHop;
  }

  seconds(index: number): number {
    return this.where[index]!.seconds;
  }

  /** How many hops have come at `seconds`, that instant included. */
  countUntil(seconds: number): number {
    let low = 0;
    let high = this.where.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.where[middle]!.seconds <= seconds) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}
