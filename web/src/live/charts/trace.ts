// SPDX-License-Identifier: MIT
// Lines of tracks: broken where a voice ends, where hops are missing, and at the wrap of the azimuth; many hops in a column of pixels
// become its first, lowest, highest and last, so that none of them is lost to the eye.
import type { HopRing } from "../../store/hops";

export interface Pen {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}

/** Hops `[from, to)` in which slot `slot` held the same visible voice without a break. */
export interface Piece {
  id: number;
  from: number;
  to: number;
}

/** Missing hops up to this many do not break a line. */
const kBridge = 2;

export function pieces(ring: HopRing, slot: number, from: number, to: number, shows: (cell: number) => boolean): Piece[] {
  const result: Piece[] = [];
  let open: Piece | null = null;
  let t = 0;
  for (let hop = from; hop < to; hop++) {
    const cell = ring.cell(hop, slot);
    const id = ring.id[cell]!;
    const at = ring.t[hop % ring.capacity]!;
    const visible = id !== 0 && shows(cell);
    if (open && (!visible || id !== open.id || at - t > kBridge)) open = null;
    if (visible && !open) {
      open = { id, from: hop, to: hop + 1 };
      result.push(open);
    } else if (open) open.to = hop + 1;
    t = at;
  }
  return result;
}

/**
 * Draws `values[cell]` of a piece. `x` turns seconds into pixels, `y` degrees. With `wraps`, a step of more than half a turn goes to the
 * edge and comes in again at the other one.
 */
export function trace(ring: HopRing, slot: number, piece: Piece, values: Float32Array, x: (time: number) => number, y: (degrees: number) => number, wraps: boolean, pen: Pen): void {
  let column = NaN;
  let first = 0;
  let low = 0;
  let high = 0;
  let last = 0;
  let count = 0;
  let lowFirst = true;

  const flush = () => {
    if (count === 0) return;
    if (count === 1) return void (count = 0);
    if (count > 2) {
      pen.lineTo(column, y(lowFirst ? low : high));
      pen.lineTo(column, y(lowFirst ? high : low));
    }
    pen.lineTo(column, y(last));
    count = 0;
  };

  let before = NaN;
  let beforeX = 0;
  for (let hop = piece.from; hop < piece.to; hop++) {
    const value = values[ring.cell(hop, slot)]!;
    const px = x(ring.time(hop));
    if (Number.isNaN(before)) pen.moveTo(px, y(value));
    else if (wraps && Math.abs(value - before) > 180) {
      flush();
      const edge = value < before ? 180 : -180;
      const rest = Math.abs(edge - before);
      const whole = rest + Math.abs(-edge - value);
      const crossing = whole > 0 ? beforeX + (px - beforeX) * (rest / whole) : px;
      pen.lineTo(crossing, y(edge));
      pen.moveTo(crossing, y(-edge));
      pen.lineTo(px, y(value));
      column = NaN;
    }
    if (Math.floor(px) === Math.floor(column) && count > 0) {
      if (value < low) {
        low = value;
        lowFirst = false;
      }
      if (value > high) {
        high = value;
        lowFirst = true;
      }
      last = value;
      count++;
    } else {
      flush();
      column = px;
      first = low = high = last = value;
      lowFirst = true;
      count = 1;
      if (!Number.isNaN(before)) pen.lineTo(px, y(first));
    }
    before = value;
    beforeX = px;
  }
  flush();
  if (piece.to - piece.from === 1) pen.lineTo(beforeX + 1, y(before));
}
