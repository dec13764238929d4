// SPDX-License-Identifier: MIT
// Directions as angles in degrees: azimuth from +x towards +y, elevation above the xy plane.
import type { Vec3 } from "../socket/messages";

const kDegrees = 180 / Math.PI;

export function azimuth(x: number, y: number): number {
  return Math.atan2(y, x) * kDegrees;
}

export function elevation(x: number, y: number, z: number): number {
  return Math.atan2(z, Math.hypot(x, y)) * kDegrees;
}

/** The unit vector of two angles in degrees. */
export function direction(az: number, el: number): Vec3 {
  const a = az / kDegrees;
  const e = el / kDegrees;
  return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
}

/** `degrees` turned into -180...180. */
export function wrap(degrees: number): number {
  return degrees - 360 * Math.round(degrees / 360);
}

/** Whether `az` lies between `from` and `to`, going up; `from > to` is the region over the back. Equal ends: everything. */
export function inRegion(az: number, from: number, to: number): boolean {
  if (from === to) return true;
  return from < to ? az >= from && az <= to : az >= from || az <= to;
}
