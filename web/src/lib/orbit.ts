// SPDX-License-Identifier: MIT
// A camera that goes round the origin: points in space as points of a drawing, without WebGL.
import type { Vec3 } from "../socket/messages";

export interface Orbit {
  /** Degrees: where the eye stands. */
  azimuth: number;
  elevation: number;
}

export interface Spot {
  /** Right and up, in units of the scene. */
  x: number;
  y: number;
  /** Towards the eye: what is greater hides what is less. */
  depth: number;
}

/** Seen from so far that lines stay parallel: lengths can be compared. */
export function look({ azimuth, elevation }: Orbit, [x, y, z]: Vec3): Spot {
  const a = (azimuth * Math.PI) / 180;
  const e = (elevation * Math.PI) / 180;
  const towards = x * Math.cos(a) + y * Math.sin(a);
  return {
    x: -x * Math.sin(a) + y * Math.cos(a),
    y: -towards * Math.sin(e) + z * Math.cos(e),
    depth: towards * Math.cos(e) + z * Math.sin(e),
  };
}

export function turned(orbit: Orbit, right: number, up: number): Orbit {
  return {
    azimuth: ((((orbit.azimuth + right) % 360) + 540) % 360) - 180,
    elevation: Math.min(90, Math.max(-90, orbit.elevation + up)),
  };
}

export const kViews = {
  top: { azimuth: -90, elevation: 90 },
  front: { azimuth: 0, elevation: 0 },
  side: { azimuth: -90, elevation: 0 },
  iso: { azimuth: -55, elevation: 32 },
} as const satisfies Record<string, Orbit>;
