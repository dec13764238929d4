// SPDX-License-Identifier: MIT
// Arrays of the usual shapes, in metres, round the origin; the first microphone of a circle is on +x.
import type { Vec3 } from "../socket/messages";

export type Shape = "circular" | "linear" | "rectangular" | "tetrahedron";
export const kShapes: Shape[] = ["circular", "linear", "rectangular", "tetrahedron"];

export interface Template {
  shape: Shape;
  /** Of a circle or a line; of a rectangle, along x. */
  count: number;
  /** Of a rectangle, along y. */
  rows: number;
  /** Radius of a circle, edge of a tetrahedron, else the spacing, m. */
  size: number;
}

export interface PlacedMic {
  position: Vec3;
  direction: Vec3;
}

export function makeArray({ shape, count, rows, size }: Template): PlacedMic[] {
  const up: Vec3 = [0, 0, 1];
  if (shape === "circular") {
    return times(count, (i) => {
      const angle = (2 * Math.PI * i) / count;
      return { position: rounded([size * Math.cos(angle), size * Math.sin(angle), 0]), direction: up };
    });
  }
  if (shape === "linear") {
    // A line hears all round itself; its microphones look away from the wall that it mostly hangs on.
    return times(count, (i) => ({ position: rounded([0, (i - (count - 1) / 2) * size, 0]), direction: [1, 0, 0] }));
  }
  if (shape === "rectangular") {
    return times(count * rows, (i) => ({
      position: rounded([((i % count) - (count - 1) / 2) * size, (Math.floor(i / count) - (rows - 1) / 2) * size, 0]),
      direction: up,
    }));
  }
  const r = size / Math.sqrt(8);
  const corners: Vec3[] = [[r, r, r], [r, -r, -r], [-r, r, -r], [-r, -r, r]];
  return corners.map((corner) => ({ position: rounded(corner), direction: rounded(corner.map((c) => c / (r * Math.sqrt(3))) as Vec3) }));
}

function times<T>(count: number, make: (i: number) => T): T[] {
  return Array.from({ length: Math.max(0, Math.floor(count)) }, (_, i) => make(i));
}

/** To a hundredth of a millimetre: what is written into a file is read by people too. */
function rounded(v: Vec3): Vec3 {
  return v.map((c) => Math.round(c * 1e5) / 1e5 + 0) as Vec3;
}

/** Pairs of microphones, from 1, that are in one place. */
export function sharedPlaces(positions: readonly (readonly number[])[], within = 1e-4): [number, number][] {
  const pairs: [number, number][] = [];
  positions.forEach((a, i) =>
    positions.slice(0, i).forEach((b, j) => {
      if (Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!) < within) pairs.push([j + 1, i + 1]);
    }),
  );
  return pairs;
}
