// SPDX-License-Identifier: MIT
// Words and marks over the sphere: degrees, numbers of voices and microphones, pinned and muted directions.
import type { Target, Vec3 } from "../../socket/messages";
import { direction } from "../../store/angles";
import { colorOf, inks, markerPath } from "../palette";
import type { Frame } from "./frame";
import type { Projected, Stage } from "./stage";

export interface Marks {
  flat: boolean;
  mics: Vec3[];
  mic: number | null;
  pointed: number | null;
  targets: Target[];
}

export function drawOverlay(draw: CanvasRenderingContext2D, width: number, height: number, stage: Stage, frame: Frame, marks: Marks): void {
  const ink = inks();
  draw.clearRect(0, 0, width, height);
  draw.textAlign = "center";
  draw.textBaseline = "middle";
  draw.font = "11px system-ui, sans-serif";
  draw.fillStyle = ink.text;
  drawDegrees(draw, width, stage, frame, marks.flat);

  draw.font = "10px system-ui, sans-serif";
  if (!marks.flat && width > 260) {
    marks.mics.forEach((mic, k) => {
      const { x, y } = stage.project(mic);
      draw.fillStyle = marks.mic === k ? ink.accent : ink.text;
      if (marks.mics.length <= 16 || marks.mic === k) draw.fillText(String(k + 1), x, y - 11);
    });
  }
  for (const target of marks.targets) drawTarget(draw, stage, target, ink.strong, ink.bad);

  for (const { id, look, az, el } of frame.balls) {
    const { x, y, front } = stage.project(direction(az, el));
    const r = marks.pointed === id ? 11 : 8.5;
    draw.globalAlpha = front ? 1 : 0.55;
    markerPath(draw, look.marker, x, y, r + 3);
    draw.strokeStyle = colorOf(look);
    draw.lineWidth = 1.5;
    draw.stroke();
    draw.font = "600 12px system-ui, sans-serif";
    const text = `#${id}`;
    const wide = draw.measureText(text).width + 8;
    const left = besideRight(x, width) ? x + r + 5 : x - r - 5 - wide;
    draw.fillStyle = ink.ground;
    draw.globalAlpha = front ? 0.85 : 0.5;
    draw.beginPath();
    draw.roundRect(left, y - 9, wide, 18, 5);
    draw.fill();
    draw.globalAlpha = front ? 1 : 0.7;
    draw.fillStyle = ink.strong;
    draw.fillText(text, left + wide / 2, y + 0.5);
  }
  draw.globalAlpha = 1;
}

/** Degrees around the sphere, each where no voice and no other number stands; those in front come first. */
function drawDegrees(draw: CanvasRenderingContext2D, width: number, stage: Stage, frame: Frame, flat: boolean): void {
  const out = flat ? 1 : 1.1;
  const labels: (Projected & { text: string })[] = [];
  for (let az = -150; az <= 180; az += 30) labels.push({ text: degrees(az, ""), ...stage.project(scaled(direction(az, flat ? -83 : 0), out)) });
  for (const el of [-60, -30, 30, 60]) labels.push({ text: degrees(el, "+"), ...stage.project(scaled(direction(flat ? 172 : 0, el), out)) });
  const taken = frame.balls.flatMap(({ az, el }) => {
    const { x, y } = stage.project(direction(az, el));
    return [{ x, y }, { x: x + (besideRight(x, width) ? 28 : -28), y }];
  });
  for (const { text, x, y, front } of labels.sort((a, b) => Number(b.front) - Number(a.front))) {
    if (taken.some((other) => Math.abs(other.x - x) < 30 && Math.abs(other.y - y) < 14)) continue;
    taken.push({ x, y });
    draw.globalAlpha = front ? 1 : 0.4;
    draw.fillText(text, x, y);
  }
  draw.globalAlpha = 1;
}

/** The number of a ball stands to its right, or to its left where there is no room for it. */
const besideRight = (x: number, width: number) => x + 50 < width;

const degrees = (value: number, plus: string) => `${value < 0 ? "\u2212" : plus}${Math.abs(value)}°`;

function drawTarget(draw: CanvasRenderingContext2D, stage: Stage, target: Target, ink: string, bad: string): void {
  const { x, y, front } = stage.project(target.direction);
  draw.globalAlpha = front ? 1 : 0.4;
  draw.strokeStyle = draw.fillStyle = target.mute ? bad : ink;
  draw.lineWidth = 1.75;
  draw.beginPath();
  draw.arc(x, y, 7, 0, 2 * Math.PI);
  if (target.mute) {
    draw.moveTo(x - 5, y + 5);
    draw.lineTo(x + 5, y - 5);
  } else {
    draw.moveTo(x, y - 11);
    draw.lineTo(x, y + 11);
    draw.moveTo(x - 11, y);
    draw.lineTo(x + 11, y);
  }
  draw.stroke();
  draw.font = "11px system-ui, sans-serif";
  draw.fillText(target.tag, x, y + 19);
}

function scaled([x, y, z]: Vec3, by: number): Vec3 {
  return [x * by, y * by, z * by];
}
