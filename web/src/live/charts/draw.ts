// SPDX-License-Identifier: MIT
// One chart of angles over time on a 2-D canvas.
import type { Track } from "../../store/tracks";
import { colorOf, inks, markerPath, ramp, rampIndex, type Inks } from "../palette";
import type { View } from "../view";
import { pieces, trace } from "./trace";
import { kDashes } from "../../store/colors";

export interface Axis {
  kind: "az" | "el";
  limit: number;
  step: number;
}

export const kAxes: Record<"az" | "el", Axis> = {
  az: { kind: "az", limit: 180, step: 60 },
  el: { kind: "el", limit: 90, step: 30 },
};

export const kMargin = { left: 50, right: 40, top: 8, bottom: 20 };

/** Side of a dot of a potential, in CSS pixels. */
const kDot = 2;

export interface Plot {
  width: number;
  height: number;
  x: (time: number) => number;
  y: (degrees: number) => number;
  time: (x: number) => number;
}

export function plotOf(view: View, axis: Axis, width: number, height: number): Plot {
  const right = view.right;
  const inner = Math.max(1, width - kMargin.left - kMargin.right);
  const tall = Math.max(1, height - kMargin.top - kMargin.bottom);
  const scale = inner / view.span.value;
  return {
    width,
    height,
    x: (time) => kMargin.left + inner - (right - time) * scale,
    y: (degrees) => kMargin.top + tall * (0.5 - degrees / (2 * axis.limit)),
    time: (x) => right - (kMargin.left + inner - x) / scale,
  };
}

export function clock(seconds: number): string {
  const whole = Math.floor(seconds + 1e-6);
  const minutes = Math.floor(whole / 60);
  return `${minutes}:${String(whole - 60 * minutes).padStart(2, "0")}`;
}

/** Distance of the lines of time, in seconds, so that a label has room. */
export function tickStep(span: number, width: number): number {
  const least = (span * 64) / Math.max(1, width);
  return [1, 2, 5, 10, 20, 30, 60, 120, 300].find((step) => step >= least) ?? 600;
}

export function drawChart(draw: CanvasRenderingContext2D, view: View, axis: Axis, width: number, height: number): void {
  const plot = plotOf(view, axis, width, height);
  const ink = inks();
  draw.fillStyle = ink.ground;
  draw.fillRect(0, 0, width, height);
  drawGrid(draw, view, axis, plot, ink);
  draw.save();
  draw.beginPath();
  draw.rect(kMargin.left, 0, width - kMargin.left - kMargin.right + 1, height - kMargin.bottom + 2);
  draw.clip();
  const ring = view.store.ring;
  const from = Math.max(ring.first, ring.at(view.right - view.span.value) - 1);
  const to = Math.min(ring.end, ring.at(view.right + ring.period / 2));
  if (view.filters.value.potentials) drawPeaks(draw, view, axis, plot, from, to);
  const ends = drawLines(draw, view, axis, plot, from, to);
  drawCursor(draw, view, plot, ink);
  draw.restore();
  drawEnds(draw, ends, plot, ink);
}

function drawGrid(draw: CanvasRenderingContext2D, view: View, axis: Axis, plot: Plot, ink: Inks): void {
  draw.lineWidth = 1;
  draw.font = "11px system-ui, sans-serif";
  draw.fillStyle = ink.text;
  draw.textAlign = "right";
  draw.textBaseline = "middle";
  const rightEdge = plot.width - kMargin.right;
  for (let degrees = -axis.limit; degrees <= axis.limit; degrees += axis.step) {
    const y = Math.round(plot.y(degrees)) + 0.5;
    draw.strokeStyle = ink.grid;
    draw.globalAlpha = degrees === 0 || Math.abs(degrees) === axis.limit ? 1 : 0.75;
    draw.beginPath();
    draw.moveTo(kMargin.left, y);
    draw.lineTo(rightEdge, y);
    draw.stroke();
    draw.globalAlpha = 1;
    const room = plot.height > 110 || degrees % axis.limit === 0;
    if (room) draw.fillText(`${degrees < 0 ? "\u2212" : ""}${Math.abs(degrees)}°`, kMargin.left - 8, y);
  }
  const step = tickStep(view.span.value, plot.width - kMargin.left - kMargin.right);
  draw.textAlign = "center";
  draw.textBaseline = "alphabetic";
  for (let time = Math.ceil((view.right - view.span.value) / step) * step; time <= view.right; time += step) {
    if (time < 0) continue;
    const x = Math.round(plot.x(time)) + 0.5;
    draw.globalAlpha = 0.6;
    draw.beginPath();
    draw.moveTo(x, kMargin.top);
    draw.lineTo(x, plot.height - kMargin.bottom);
    draw.stroke();
    draw.globalAlpha = 1;
    draw.fillText(clock(time), x, plot.height - 5);
  }
}

let dots: { canvas: OffscreenCanvas; image: ImageData } | null = null;

/** Every potential, as dots in a small picture that is put on the chart at once; where several fall together, the strongest shows. */
function drawPeaks(draw: CanvasRenderingContext2D, view: View, axis: Axis, plot: Plot, from: number, to: number): void {
  const ring = view.store.ring;
  const columns = Math.max(1, Math.ceil(plot.width / kDot));
  const rows = Math.max(1, Math.ceil(plot.height / kDot));
  if (!dots || dots.canvas.width !== columns || dots.canvas.height !== rows) {
    dots = { canvas: new OffscreenCanvas(columns, rows), image: new ImageData(columns, rows) };
  }
  const pixels = dots.image.data;
  pixels.fill(0);
  const colors = ramp();
  const range = view.filters.value.energy;
  const angles = axis.kind === "az" ? ring.peakAz : ring.peakEl;
  for (let hop = from; hop < to; hop++) {
    const column = Math.floor(plot.x(ring.time(hop)) / kDot);
    if (column < 0 || column >= columns) continue;
    for (let k = 0; k < ring.peaks; k++) {
      const cell = ring.peak(hop, k);
      const energy = ring.energy[cell]!;
      if (!(energy > 0) || !view.showsPeak(ring.peakAz[cell]!, energy)) continue;
      const row = Math.min(rows - 1, Math.max(0, Math.floor(plot.y(angles[cell]!) / kDot)));
      const pixel = 4 * (row * columns + column);
      const index = rampIndex(energy, range);
      const alpha = 70 + 0.7 * index;
      if (pixels[pixel + 3]! > alpha) continue;
      pixels[pixel] = colors[3 * index]!;
      pixels[pixel + 1] = colors[3 * index + 1]!;
      pixels[pixel + 2] = colors[3 * index + 2]!;
      pixels[pixel + 3] = alpha;
    }
  }
  dots.canvas.getContext("2d")!.putImageData(dots.image, 0, 0);
  draw.imageSmoothingEnabled = false;
  draw.drawImage(dots.canvas, 0, 0, columns * kDot, rows * kDot);
}

interface End {
  track: { id: number; look: Track["look"] };
  y: number;
}

/** All lines; gives those that reach the right end. */
function drawLines(draw: CanvasRenderingContext2D, view: View, axis: Axis, plot: Plot, from: number, to: number): End[] {
  const ring = view.store.ring;
  const values = axis.kind === "az" ? ring.az : ring.el;
  const pointed = view.hovered.value ?? view.selected.value;
  const ends: End[] = [];
  draw.lineJoin = "round";
  for (let slot = 0; slot < ring.slots; slot++) {
    const shows = (cell: number) => view.showsVoice(ring.id[cell]!, ring.az[cell]!, ring.activity[cell]!);
    for (const piece of pieces(ring, slot, from, to, shows)) {
      const look = view.store.tracks.lookOf(piece.id);
      draw.strokeStyle = colorOf(look);
      draw.globalAlpha = pointed === null || pointed === piece.id ? 1 : 0.35;
      draw.lineWidth = pointed === piece.id ? 3.5 : 2.25;
      draw.setLineDash(kDashes[look.dash] as number[]);
      draw.beginPath();
      trace(ring, slot, piece, values, plot.x, plot.y, axis.kind === "az", draw);
      draw.stroke();
      if (piece.to === to) ends.push({ track: { id: piece.id, look }, y: plot.y(values[ring.cell(piece.to - 1, slot)]!) });
    }
  }
  draw.globalAlpha = 1;
  draw.setLineDash([]);
  return ends;
}

/** Marker and number of each voice at the right end; numbers keep off one another. */
function drawEnds(draw: CanvasRenderingContext2D, ends: End[], plot: Plot, ink: Inks): void {
  draw.textAlign = "left";
  draw.textBaseline = "middle";
  draw.font = "600 11px system-ui, sans-serif";
  let below = -Infinity;
  const x = plot.width - kMargin.right;
  for (const { track, y } of ends.sort((a, b) => a.y - b.y)) {
    markerPath(draw, track.look.marker, x, y, 4.5);
    draw.fillStyle = colorOf(track.look);
    draw.fill();
    draw.strokeStyle = ink.ground;
    draw.lineWidth = 1;
    draw.stroke();
    const at = Math.max(y, below + 12);
    below = at;
    draw.fillStyle = ink.strong;
    if (at < plot.height - 4) draw.fillText(String(track.id), x + 9, at);
  }
}

function drawCursor(draw: CanvasRenderingContext2D, view: View, plot: Plot, ink: Inks): void {
  const cursor = view.cursor.value;
  if (cursor === null) return;
  const x = Math.round(plot.x(cursor)) + 0.5;
  draw.strokeStyle = ink.strong;
  draw.globalAlpha = 0.6;
  draw.lineWidth = 1;
  draw.beginPath();
  draw.moveTo(x, kMargin.top);
  draw.lineTo(x, plot.height - kMargin.bottom);
  draw.stroke();
  draw.globalAlpha = 1;
}
