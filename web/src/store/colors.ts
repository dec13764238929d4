// SPDX-License-Identifier: MIT
// A look for each track: colour, dash and marker, stable for its life and not given to another one for a while after.

/**
 * Eight colours for each background, contrast at least 3:1 on it, far apart also for eyes without red, green or blue
 * (test/unit/colors.test.ts measures both).
 */
export const kPalettes = {
  light: ["#b36f84", "#5a1069", "#6351fb", "#a9170a", "#220ebe", "#6e4e6b", "#8f81d3", "#db551d"],
  dark: ["#f1aa92", "#3d51f3", "#b0451a", "#4ea6fb", "#ac8094", "#caed0a", "#5fe6fc", "#81569f"],
} as const;

export const kBackgrounds = { light: "#ffffff", dark: "#0f1419" } as const;

/** Canvas dashes in CSS pixels, one for each round of the palette and shifted within it. */
export const kDashes: readonly (readonly number[])[] = [[], [8, 4], [2, 3], [10, 3, 2, 3]];

export const kMarkers = ["circle", "square", "triangle", "diamond"] as const;

export type Marker = (typeof kMarkers)[number];

export const kColors = kPalettes.light.length;

/** How many looks there are: every colour with every dash; the marker goes with both. */
export const kLooks = kColors * kDashes.length;

export interface Look {
  color: number;
  dash: number;
  marker: Marker;
}

export function lookOf(index: number): Look {
  const color = index % kColors;
  const round = Math.floor(index / kColors);
  const dash = (color + round) % kDashes.length;
  return { color, dash, marker: kMarkers[(Math.floor(color / 2) + round) % kMarkers.length]! };
}

/** Seconds before the look of a track that ended may be another's. */
export const kRest = 10;

/** Hands out looks. Times are seconds of the run. */
export class LookAllocator {
  private readonly held = new Map<number, number>();
  private readonly freed: number[] = new Array<number>(kLooks).fill(-Infinity);
  private next = 0;

  /** The look of track `id`, the same until it is released. */
  of(id: number, now: number): number {
    const mine = this.held.get(id);
    if (mine !== undefined) return mine;
    const index = this.choose(now);
    this.held.set(id, index);
    this.next = (index + 1) % kLooks;
    return index;
  }

  release(id: number, now: number): void {
    const index = this.held.get(id);
    if (index === undefined) return;
    this.held.delete(id);
    this.freed[index] = now;
  }

  clear(): void {
    this.held.clear();
    this.freed.fill(-Infinity);
    this.next = 0;
  }

  /** A rested look whose colour nobody has; else one that nobody has; else the one that has rested longest. */
  private choose(now: number): number {
    const used = new Set(this.held.values());
    const colors = new Set([...used].map((index) => index % kColors));
    let longest = -1;
    let other = -1;
    for (let step = 0; step < kLooks; step++) {
      const index = (this.next + step) % kLooks;
      if (used.has(index)) continue;
      if (now - this.freed[index]! >= kRest) {
        if (!colors.has(index % kColors) && this.rested(index % kColors, now)) return index;
        if (other < 0) other = index;
      }
      if (longest < 0 || this.freed[index]! < this.freed[longest]!) longest = index;
    }
    if (other >= 0) return other;
    return longest >= 0 ? longest : this.next;
  }

  private rested(color: number, now: number): boolean {
    for (let index = color; index < kLooks; index += kColors) if (now - this.freed[index]! < kRest) return false;
    return true;
  }
}
