// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { kBackgrounds, kLooks, kPalettes, kRest, LookAllocator, lookOf } from "../../src/store/colors";

type Rgb = [number, number, number];

function linear(hex: string): Rgb {
  return [1, 3, 5].map((k) => {
    const value = parseInt(hex.slice(k, k + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  }) as Rgb;
}

/** Contrast of WCAG 2. */
function contrast(a: string, b: string): number {
  const luminance = (hex: string) => linear(hex).reduce((sum, value, k) => sum + value * [0.2126, 0.7152, 0.0722][k]!, 0);
  const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

/** Björn Ottosson, "A perceptual color space for image processing", 2020. */
function oklab([r, g, b]: Rgb): Rgb {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/** Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision deficiency", 2009, severity 1. */
const kEyes: Record<string, number[]> = {
  normal: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protan: [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
  deutan: [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881],
  tritan: [1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039],
};

function seen(rgb: Rgb, eyes: number[]): Rgb {
  return [0, 1, 2].map((k) => Math.min(1, Math.max(0, eyes[3 * k]! * rgb[0] + eyes[3 * k + 1]! * rgb[1] + eyes[3 * k + 2]! * rgb[2]))) as Rgb;
}

for (const theme of ["light", "dark"] as const) {
  test(`${theme}: every colour stands out from the background by 3:1 at least`, () => {
    for (const color of kPalettes[theme]) assert.ok(contrast(color, kBackgrounds[theme]) >= 3, `${color}: ${contrast(color, kBackgrounds[theme])}`);
    if (theme === "dark") for (const color of kPalettes.dark) assert.ok(contrast(color, "#000000") >= 3, `${color} on black`);
  });

  for (const [name, eyes] of Object.entries(kEyes)) {
    test(`${theme}: no two colours look alike to ${name} eyes`, () => {
      const labs = kPalettes[theme].map((color) => oklab(seen(linear(color), eyes)));
      let least = Infinity;
      labs.forEach((a, i) => labs.slice(i + 1).forEach((b) => (least = Math.min(least, Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])))));
      assert.ok(least >= 0.1, `least distance ${least.toFixed(3)}`);
    });
  }
}

test("a track keeps its look for life", () => {
  const looks = new LookAllocator();
  const mine = looks.of(7, 0);
  for (let id = 100; id < 200; id++) {
    looks.of(id, id);
    looks.release(id, id + 0.5);
    assert.equal(looks.of(7, id), mine);
  }
});

test("the colour of a track that ended rests for ten seconds", () => {
  const looks = new LookAllocator();
  const ended = new Map<number, number>();
  let now = 0;
  for (let id = 1; id < 400; id++) {
    now += 1.7;
    const look = looks.of(id, now);
    const color = lookOf(look).color;
    const since = now - (ended.get(color) ?? -Infinity);
    assert.ok(since >= kRest, `track ${id} took colour ${color} after ${since} s`);
    now += 0.4;
    looks.release(id, now);
    ended.set(color, now);
  }
});

test("as many voices as there are looks have different ones, and one more gets one too", () => {
  const looks = new LookAllocator();
  const all = new Set<number>();
  for (let id = 1; id <= kLooks; id++) all.add(looks.of(id, 0));
  assert.equal(all.size, kLooks);
  assert.ok(looks.of(kLooks + 1, 0) < kLooks);
  const first = [...Array(8).keys()].map((index) => lookOf(index));
  assert.equal(new Set(first.map((look) => look.color)).size, 8);
});

test("looks of the same colour differ in their dash", () => {
  for (let color = 0; color < 8; color++) {
    const dashes = [0, 1, 2, 3].map((round) => lookOf(8 * round + color).dash);
    assert.equal(new Set(dashes).size, 4);
  }
});
