// SPDX-License-Identifier: MIT
// The array in space, turned by pointer and arrow keys. Drawn without WebGL: it is there on every machine.
import { useRef, useState } from "preact/hooks";

import { heatColor } from "../../lib/heat";
import { kViews, look, turned, type Orbit, type Spot } from "../../lib/orbit";
import { angle } from "../../shell/units";
import type { Vec3 } from "../../socket/messages";
import { direction } from "../../store/angles";
import { Canvas, type Pen } from "../shared/canvas";
import type { ArrayCheck, FormMic } from "./array_model";
import { t } from "./texts";

interface Props {
  mics: FormMic[];
  map: ArrayCheck["error_map"] | undefined;
  chosen: number | null;
  onChoose: (mic: number | null) => void;
}

const kNames = ["iso", "top", "front", "side"] as const;

export function ArrayScene({ mics, map, chosen, onChoose }: Props) {
  const [orbit, setOrbit] = useState<Orbit>(kViews.iso);
  const spots = useRef<{ x: number; y: number; mic: number }[]>([]);
  const drag = useRef<{ x: number; y: number; moved: number } | null>(null);
  const down = (event: PointerEvent) => {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    drag.current = { x: event.clientX, y: event.clientY, moved: 0 };
  };
  const move = (event: PointerEvent) => {
    const from = drag.current;
    if (!from) return;
    const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
    drag.current = { x: event.clientX, y: event.clientY, moved: from.moved + Math.abs(dx) + Math.abs(dy) };
    setOrbit((now) => turned(now, -dx * 0.5, dy * 0.5));
  };
  const up = (event: PointerEvent) => {
    if (drag.current && drag.current.moved < 4) {
      const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
      const near = spots.current.find((spot) => Math.hypot(spot.x - (event.clientX - box.left), spot.y - (event.clientY - box.top)) < 16);
      onChoose(near?.mic ?? null);
    }
    drag.current = null;
  };
  const press = (event: KeyboardEvent) => {
    const by = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10] }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    setOrbit((now) => turned(now, by[0]!, by[1]!));
  };
  const label = t("arrayLabel", { n: mics.length, az: angle(orbit.azimuth), el: angle(orbit.elevation) });
  return (
    <div class="array-scene">
      <Canvas
        role="img" tabIndex={0} aria-label={label} data-own-keys data-mics={mics.length}
        draw={(pen) => { spots.current = drawScene(pen, mics, map, orbit, chosen); }} when={[mics, map, orbit, chosen]}
        onPointerDown={down} onPointerMove={move} onPointerUp={up} onKeyDown={press}
      />
      <div class="row-wrap scene-views">
        {kNames.map((name) => <button key={name} class="button small" aria-pressed={orbit === kViews[name]} onClick={() => setOrbit(kViews[name])}>{t(`view_${name}`)}</button>)}
      </div>
    </div>
  );
}

function drawScene(pen: Pen, mics: FormMic[], map: Props["map"], orbit: Orbit, chosen: number | null) {
  const { ctx, width, height, color } = pen;
  const reach = Math.max(0.01, ...mics.map((mic) => Math.hypot(...mic.position)));
  const sphere = reach * 1.75;
  const scale = (Math.min(width, height) / 2 - 26) / sphere;
  const place = (point: Vec3): Spot => {
    const spot = look(orbit, point);
    return { x: width / 2 + spot.x * scale, y: height / 2 - spot.y * scale, depth: spot.depth };
  };
  ctx.clearRect(0, 0, width, height);
  if (map) drawMap(ctx, map, (d) => place([d[0] * sphere, d[1] * sphere, d[2] * sphere]), scale * sphere);
  drawRings(pen, place, sphere, map !== undefined);
  drawAxes(pen, place, sphere);
  return drawMics(pen, mics, place, reach, chosen, color("accent"));
}

function drawMap(ctx: CanvasRenderingContext2D, map: NonNullable<Props["map"]>, place: (d: Vec3) => Spot, radius: number): void {
  const { low, high } = mapRange(map);
  const dot = Math.max(3, radius * Math.sqrt(14 / Math.max(1, map.directions.length)) * 0.62);
  for (const [behind, alpha] of [[true, 0.16], [false, 0.8]] as const) {
    ctx.globalAlpha = alpha;
    map.directions.forEach((d, i) => {
      const degrees = map.degrees[i];
      const spot = place(d);
      if (degrees === null || degrees === undefined || spot.depth < 0 !== behind) return;
      ctx.fillStyle = heatColor((degrees - low) / (high - low || 1));
      ctx.beginPath();
      ctx.arc(spot.x, spot.y, dot, 0, 2 * Math.PI);
      ctx.fill();
    });
  }
  ctx.globalAlpha = 1;
}

/** From the least to what 95 of 100 directions stay below: one bad direction must not make all others look alike. */
export function mapRange(map: NonNullable<ArrayCheck["error_map"]>): { low: number; high: number } {
  const known = map.degrees.filter((value): value is number => value !== null).sort((a, b) => a - b);
  return { low: known[0] ?? 0, high: known[Math.floor(known.length * 0.95)] ?? 1 };
}

function drawRings({ ctx, color }: Pen, place: (p: Vec3) => Spot, sphere: number, overHeat: boolean): void {
  ctx.lineWidth = 1;
  ctx.strokeStyle = color(overHeat ? "line-strong" : "plot-grid");
  for (const elevation of [-60, -30, 0, 30, 60]) {
    ring(ctx, place, (turn) => direction(turn, elevation), sphere);
  }
  for (const azimuth of [0, 45, 90, 135]) {
    ring(ctx, place, (turn) => {
      const [c, s] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
      const d = direction(azimuth, 0);
      return [d[0] * c, d[1] * c, s];
    }, sphere);
  }
}

function ring(ctx: CanvasRenderingContext2D, place: (p: Vec3) => Spot, at: (turn: number) => Vec3, size: number): void {
  ctx.beginPath();
  for (let turn = 0; turn <= 360; turn += 6) {
    const d = at(turn);
    const spot = place([d[0] * size, d[1] * size, d[2] * size]);
    ctx[turn === 0 ? "moveTo" : "lineTo"](spot.x, spot.y);
  }
  ctx.stroke();
}

function drawAxes({ ctx, color }: Pen, place: (p: Vec3) => Spot, sphere: number): void {
  const origin = place([0, 0, 0]);
  ctx.font = `600 12px ${getComputedStyle(document.body).fontFamily}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (const [name, axis] of [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]] as [string, Vec3][]) {
    const end = place(axis.map((c) => c * sphere) as Vec3);
    ctx.strokeStyle = ctx.fillStyle = color("plot-text");
    ctx.beginPath();
    ctx.moveTo(origin.x, origin.y);
    ctx.lineTo(end.x, end.y);
    ctx.stroke();
    const label = place(axis.map((c) => c * sphere * 1.08) as Vec3);
    if (Math.hypot(label.x - origin.x, label.y - origin.y) > 12) ctx.fillText(name, label.x, label.y);
  }
}

function drawMics({ ctx, color }: Pen, mics: FormMic[], place: (p: Vec3) => Spot, reach: number, chosen: number | null, accent: string) {
  const spots = mics.map((mic, i) => ({ ...place(mic.position), mic: i, ahead: place(ahead(mic, reach * 0.35)) }));
  ctx.font = `600 11px ${getComputedStyle(document.body).fontFamily}`;
  for (const spot of [...spots].sort((a, b) => a.depth - b.depth)) {
    ctx.fillStyle = accent;
    ctx.beginPath();
    ctx.moveTo(spot.x, spot.y);
    ctx.lineTo(spot.ahead.x, spot.ahead.y);
    for (const [ink, thick] of [["plot-ground", 5], ["accent", 2.5]] as const) {
      ctx.strokeStyle = color(ink);
      ctx.lineWidth = thick;
      ctx.stroke();
    }
    ctx.beginPath();
    ctx.arc(spot.x, spot.y, 9.5, 0, 2 * Math.PI);
    ctx.fill();
    ctx.lineWidth = spot.mic === chosen ? 3 : 1.5;
    ctx.strokeStyle = color(spot.mic === chosen ? "text" : "plot-ground");
    ctx.stroke();
    ctx.fillStyle = color("on-accent");
    ctx.fillText(String(spot.mic + 1), spot.x, spot.y + 0.5);
  }
  return spots;
}

function ahead({ position, direction: d }: FormMic, by: number): Vec3 {
  const norm = Math.hypot(...d) || 1;
  return position.map((c, i) => c + (d[i]! / norm) * by) as Vec3;
}
