// SPDX-License-Identifier: MIT
// One colour map for everything that is warm: dark blue to yellow, even in lightness, the same for colour-blind eyes
// (after cividis: Nunez, Anderton, Renslow, PLoS ONE 2018).

type Rgb = [number, number, number];

const kStops: Rgb[] = [
  [0, 32, 76], [0, 49, 111], [58, 72, 108], [87, 93, 109], [112, 113, 115],
  [138, 134, 120], [166, 156, 117], [196, 181, 107], [225, 204, 85], [255, 234, 70],
];

/** `share` 0..1, beyond it the ends. */
export function heat(share: number): Rgb {
  const at = Math.min(Math.max(Number.isFinite(share) ? share : 0, 0), 1) * (kStops.length - 1);
  const low = Math.min(Math.floor(at), kStops.length - 2);
  const part = at - low;
  return [0, 1, 2].map((c) => Math.round(kStops[low]![c]! * (1 - part) + kStops[low + 1]![c]! * part)) as Rgb;
}

export function heatColor(share: number): string {
  return `rgb(${heat(share).join(" ")})`;
}

/** 256 colours as the bytes of a picture. */
export function heatTable(): Uint8ClampedArray {
  const table = new Uint8ClampedArray(4 * 256);
  for (let i = 0; i < 256; ++i) table.set([...heat(i / 255), 255], 4 * i);
  return table;
}
