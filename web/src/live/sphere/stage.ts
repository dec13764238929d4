// SPDX-License-Identifier: MIT
// What the sphere and the flat map have in common.
import type { PowerMap } from "../../socket/binary";
import type { Vec3 } from "../../socket/messages";
import type { Preset } from "../view";
import type { Frame } from "./frame";

/** Everything to draw that does not come with the hops. */
export interface Picture {
  pointed: number | null;
  energy: readonly [number, number];
  mics: Vec3[];
  /** Index of the chosen microphone. */
  mic: number | null;
  power: PowerMap | null;
  powerGrid: Vec3[];
}

export interface Projected {
  /** CSS pixels. */
  x: number;
  y: number;
  /** On the side that looks at the viewer. */
  front: boolean;
}

export interface Stage {
  resize(width: number, height: number, ratio: number): void;
  look(preset: Preset): void;
  /** Turns towards a direction, by `share` of the way. */
  follow(az: number, el: number, share: number): void;
  recolor(): void;
  draw(frame: Frame, picture: Picture): void;
  project(point: Vec3): Projected;
  pick(x: number, y: number): Vec3 | null;
  readonly calls: number;
  dispose(): void;
}
