// SPDX-License-Identifier: MIT
import { kPalettes, type Look } from "../store/colors";
import { shownTheme } from "../shell/theme";

/** The colour of a look on the background of now. */
export function colorOf(look: Look): string {
  return kPalettes[shownTheme.value === "light" ? "light" : "dark"][look.color]!;
}

/** Colours of the canvases, from the style's tokens. */
export interface Inks {
  ground: string;
  grid: string;
  text: string;
  strong: string;
  accent: string;
  bad: string;
}

export function inks(): Inks {
  const style = getComputedStyle(document.documentElement);
  const read = (name: string) => style.getPropertyValue(name).trim();
  return {
    ground: read("--plot-ground"),
    grid: read("--plot-grid"),
    text: read("--plot-text"),
    strong: read("--text"),
    accent: read("--accent"),
    bad: read("--bad"),
  };
}

export { rampIndex } from "./ramp";

type Rgb = readonly [number, number, number];

/** Dim to bright on dark, pale to deep on light: more energy stands out more. */
const kRamps: Record<"light" | "dark", readonly Rgb[]> = {
  light: [[196, 205, 214], [120, 160, 190], [40, 110, 150], [10, 60, 110], [60, 10, 80]],
  dark: [[44, 58, 74], [46, 98, 130], [60, 160, 160], [150, 210, 120], [250, 230, 110]],
};

const tables = new Map<string, Uint8ClampedArray>();

/** 256 colours (red, green, blue) from no energy to all of it. */
export function ramp(): Uint8ClampedArray {
  const name = shownTheme.value === "light" ? "light" : "dark";
  let table = tables.get(name);
  if (!table) {
    table = new Uint8ClampedArray(256 * 3);
    const stops = kRamps[name];
    for (let k = 0; k < 256; k++) {
      const place = (k / 255) * (stops.length - 1);
      const low = Math.min(stops.length - 2, Math.floor(place));
      for (let c = 0; c < 3; c++) table[3 * k + c] = stops[low]![c]! + (place - low) * (stops[low + 1]![c]! - stops[low]![c]!);
    }
    tables.set(name, table);
  }
  return table;
}

/** Draws a marker of radius `r` as a path. */
export function markerPath(draw: CanvasRenderingContext2D, marker: Look["marker"], x: number, y: number, r: number): void {
  draw.beginPath();
  if (marker === "circle") draw.arc(x, y, r, 0, 2 * Math.PI);
  else if (marker === "square") draw.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
  else {
    const corners = marker === "triangle" ? [[0, -1.2], [1.1, 0.8], [-1.1, 0.8]] : [[0, -1.3], [1.1, 0], [0, 1.3], [-1.1, 0]];
    corners.forEach(([dx, dy], k) => draw[k === 0 ? "moveTo" : "lineTo"](x + dx! * r, y + dy! * r));
    draw.closePath();
  }
}
