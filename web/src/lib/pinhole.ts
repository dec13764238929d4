// SPDX-License-Identifier: MIT
// Where a direction of the array is in the picture of a camera (`studio.camera` of the configuration).
import type { Vec3 } from "../socket/messages";

export interface Pinhole {
  url: string;
  width: number;
  height: number;
  fx: number;
  fy: number;
  cx: number;
  cy: number;
  /** In the frame of the array, m. */
  position: Vec3;
  /** Roll, pitch, yaw, degrees: R = Rz(yaw) Ry(pitch) Rx(roll). 0, 0, 0 looks along +x, z up; pitch above 0 looks down. */
  rotation: Vec3;
}

/** What `hello.camera` says, with what it leaves out; `null` if there is none to show. */
export function readPinhole(camera: unknown): Pinhole | null {
  if (typeof camera !== "object" || camera === null) return null;
  const given = camera as Partial<Record<keyof Pinhole, unknown>>;
  if (typeof given.url !== "string" || !given.url) return null;
  const number = (value: unknown, fallback: number) => (typeof value === "number" && Number.isFinite(value) ? value : fallback);
  const vector = (value: unknown): Vec3 =>
    Array.isArray(value) ? [number(value[0], 0), number(value[1], 0), number(value[2], 0)] : [0, 0, 0];
  const width = number(given.width, 640);
  const height = number(given.height, 480);
  return {
    url: given.url, width, height,
    fx: number(given.fx, 550), fy: number(given.fy, 550),
    cx: number(given.cx, width / 2), cy: number(given.cy, height / 2),
    position: vector(given.position), rotation: vector(given.rotation),
  };
}

/** A pixel of the picture, or `null` for what is behind the camera, beside the picture or nowhere. `distance`: of the source from the array, m. */
export function project(camera: Pinhole, direction: Vec3, distance = Infinity): { x: number; y: number } | null {
  const norm = Math.hypot(...direction);
  if (!(norm > 0)) return null;
  const point = direction.map((c, i) =>
    Number.isFinite(distance) ? (c / norm) * distance - camera.position[i]! : c / norm,
  ) as Vec3;
  const [forward, left, up] = intoBody(point, camera.rotation);
  // 1e-6: what is beside the camera's own plane would be far outside of any picture.
  if (!(forward > 1e-6)) return null;
  const x = camera.cx - (camera.fx * left) / forward;
  const y = camera.cy - (camera.fy * up) / forward;
  return x >= 0 && y >= 0 && x < camera.width && y < camera.height ? { x, y } : null;
}

/** The transpose of R takes what is in the array's frame into the camera's: forward, left, up. */
function intoBody([x, y, z]: Vec3, [roll, pitch, yaw]: Vec3): Vec3 {
  const [cr, cp, cy] = [roll, pitch, yaw].map((d) => Math.cos((d * Math.PI) / 180)) as Vec3;
  const [sr, sp, sy] = [roll, pitch, yaw].map((d) => Math.sin((d * Math.PI) / 180)) as Vec3;
  return [
    cy * cp * x + sy * cp * y - sp * z,
    (cy * sp * sr - sy * cr) * x + (sy * sp * sr + cy * cr) * y + cp * sr * z,
    (cy * sp * cr + sy * sr) * x + (sy * sp * cr - cy * sr) * y + cp * cr * z,
  ];
}
