// SPDX-License-Identifier: MIT
/** Where in the ramp an energy stands when `range` is what the filter lets through; equal ends are safe. */
export function rampIndex(energy: number, range: readonly [number, number]): number {
  const width = range[1] - range[0];
  const share = width > 0 ? (energy - range[0]) / width : energy >= range[0] ? 1 : 0;
  return Math.round(255 * Math.min(1, Math.max(0, share || 0)));
}
