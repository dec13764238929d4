// SPDX-License-Identifier: MIT
// Things to look at.
import { potential, track } from "./fixtures.mjs";

/** `count` voices that stand around and sway a little. */
export function voices(count) {
  return (t) =>
    Array.from({ length: count }, (_, k) =>
      track(k, 11 + k, [-150 + (k * 360) / Math.max(1, count) + 12 * Math.sin(t / 170 + k), -20 + ((k * 37) % 60) + 4 * Math.sin(t / 90 + 2 * k)], {
        activity: 0.6 + 0.4 * Math.abs(Math.sin(t / 60 + k)),
        level: -30 + 12 * Math.sin(t / 23 + k),
        category: k % 3,
      }),
    );
}

/** Potentials near the voices, and some that are only noise. */
export function noise(count) {
  const of = voices(count);
  let state = 7;
  const random = () => ((state = (state * 16807) % 2147483647) / 2147483647);
  return (t) => {
    const near = of(t).slice(0, 2).map(([, , x, y, z]) => [Math.atan2(y, x) * 57.3 + 8 * (random() - 0.5), Math.asin(z) * 57.3 + 8 * (random() - 0.5)]);
    const far = [[360 * random() - 180, 60 * random()], [360 * random() - 180, 60 * random() - 20]];
    return [...near.map((at) => potential(at, 0.5 + 0.4 * random())), ...far.map((at) => potential(at, 0.25 * random()))];
  };
}
