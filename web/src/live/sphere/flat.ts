// SPDX-License-Identifier: MIT
// The same directions on a flat map (azimuth across, elevation up), where there is no WebGL.
import type { Vec3 } from "../../socket/messages";
import { azimuth, direction, elevation } from "../../store/angles";
import { kDashes } from "../../store/colors";
import { colorOf, inks, markerPath, ramp, rampIndex } from "../palette";
import type { Frame } from "./frame";
import type { Picture, Projected, Stage } from "./stage";

const kMargin = 22;

export class FlatMap implements Stage {
  readonly calls = 0;
  private readonly draw2d: CanvasRenderingContext2D;
  private width = 1;
  private height = 1;
  private ratio = 1;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.draw2d = canvas.getContext("2d")!;
  }

  resize(width: number, height: number, ratio: number): void {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
  }

  look(): void {}
  follow(): void {}
  recolor(): void {}
  dispose(): void {}

  project([x, y, z]: Vec3): Projected {
    return { x: this.x(azimuth(x, y)), y: this.y(elevation(x, y, z)), front: true };
  }

  pick(px: number, py: number): Vec3 | null {
    const az = 180 - ((px - kMargin) / Math.max(1, this.width - 2 * kMargin)) * 360;
    const el = 90 - ((py - kMargin) / Math.max(1, this.height - 2 * kMargin)) * 180;
    return Math.abs(az) <= 180 && Math.abs(el) <= 90 ? direction(az, el) : null;
  }

  draw(frame: Frame, picture: Picture): void {
    const draw = this.draw2d;
    draw.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.grid(draw);
    const colors = ramp();
    const dot = (az: number, el: number, index: number, opacity: number, r: number) => {
      draw.globalAlpha = opacity;
      draw.fillStyle = `rgb(${colors[3 * index]} ${colors[3 * index + 1]} ${colors[3 * index + 2]})`;
      draw.fillRect(this.x(az) - r, this.y(el) - r, 2 * r, 2 * r);
    };
    if (picture.power) {
      picture.powerGrid.forEach(([x, y, z], k) => {
        const value = picture.power!.values[k] ?? 0;
        if (value >= 8) dot(azimuth(x, y), elevation(x, y, z), value, 0.1 + (0.5 * value) / 255, 5);
      });
    }
    for (const { az, el, energy, age } of frame.sparks) dot(az, el, rampIndex(energy, picture.energy), 1 - age, 1.5);
    draw.globalAlpha = 1;
    this.mics(draw, picture);
    for (const ball of frame.balls) this.ball(draw, ball, picture.pointed === ball.id);
  }

  /** Left of the array is left on the map: azimuth grows to the left. */
  private x(az: number): number {
    return kMargin + ((180 - az) / 360) * (this.width - 2 * kMargin);
  }

  private y(el: number): number {
    return kMargin + ((90 - el) / 180) * (this.height - 2 * kMargin);
  }

  private grid(draw: CanvasRenderingContext2D): void {
    const ink = inks();
    draw.fillStyle = ink.ground;
    draw.fillRect(0, 0, this.width, this.height);
    draw.lineWidth = 1;
    draw.beginPath();
    for (let az = -180; az <= 180; az += 30) {
      draw.moveTo(this.x(az), this.y(90));
      draw.lineTo(this.x(az), this.y(-90));
    }
    for (let el = -90; el <= 90; el += 30) {
      draw.moveTo(this.x(180), this.y(el));
      draw.lineTo(this.x(-180), this.y(el));
    }
    draw.strokeStyle = ink.grid;
    draw.stroke();
    draw.beginPath();
    draw.moveTo(this.x(180), this.y(0));
    draw.lineTo(this.x(-180), this.y(0));
    draw.strokeStyle = ink.accent;
    draw.stroke();
  }

  /** The array from above, in the middle. */
  private mics(draw: CanvasRenderingContext2D, { mics, mic }: Picture): void {
    const ink = inks();
    const reach = Math.min(this.width, this.height) * 0.28;
    mics.forEach(([x, y], k) => {
      draw.beginPath();
      draw.arc(this.width / 2 - y * reach, this.height / 2 - x * reach, mic === k ? 5 : 3.5, 0, 2 * Math.PI);
      draw.fillStyle = mic === k ? ink.accent : ink.text;
      draw.fill();
    });
  }

  private ball(draw: CanvasRenderingContext2D, { look, az, el, trail }: Frame["balls"][number], pointed: boolean): void {
    draw.strokeStyle = draw.fillStyle = colorOf(look);
    draw.lineWidth = 2;
    draw.setLineDash(kDashes[look.dash] as number[]);
    draw.globalAlpha = 0.6;
    draw.beginPath();
    for (let k = 0; k < trail.length; k += 2) {
      const wrapped = k > 0 && Math.abs(trail[k]! - trail[k - 2]!) > 180;
      draw[k === 0 || wrapped ? "moveTo" : "lineTo"](this.x(trail[k]!), this.y(trail[k + 1]!));
    }
    draw.stroke();
    draw.setLineDash([]);
    draw.globalAlpha = 1;
    markerPath(draw, look.marker, this.x(az), this.y(el), pointed ? 10 : 7);
    draw.fill();
  }
}
