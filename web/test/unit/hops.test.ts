// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { direction } from "../../src/store/angles";
import { HopRing, kKept } from "../../src/store/hops";
import { pieces, trace } from "../../src/live/charts/trace";
import { track } from "../support/fixtures.mjs";

interface Segment {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** A pen that remembers its segments. */
function pen() {
  const segments: Segment[] = [];
  let x0 = NaN;
  let y0 = NaN;
  return {
    segments,
    moveTo(x: number, y: number) {
      [x0, y0] = [x, y];
    },
    lineTo(x: number, y: number) {
      segments.push({ x0, y0, x1: x, y1: y });
      [x0, y0] = [x, y];
    },
  };
}

function ringOf(azimuths: (number | null)[], id = 1): HopRing {
  const ring = new HopRing(4, 4, 16000, 128);
  azimuths.forEach((az, k) => ring.push({ t: k + 1, tracks: az === null ? [] : [track(0, id, [az, 0])] }));
  return ring;
}

function lines(ring: HopRing, pixelsPerSecond: number): Segment[] {
  const paper = pen();
  for (const piece of pieces(ring, 0, ring.first, ring.end, () => true)) {
    trace(ring, 0, piece, ring.az, (time) => time * pixelsPerSecond, (degrees) => degrees, true, paper);
  }
  return paper.segments;
}

test("ten minutes of hops are kept, and the eleventh pushes the first out", () => {
  const ring = new HopRing(1, 0, 16000, 1600);
  assert.equal(ring.capacity, kKept * 10);
  for (let t = 1; t <= 7000; t++) ring.push({ t, tracks: [track(0, t, [t % 180, 0])] });
  assert.equal(ring.end - ring.first, kKept * 10);
  for (let hop = ring.first; hop < ring.end; hop++) assert.equal(ring.id[ring.cell(hop, 0)], hop + 1);
  assert.equal(ring.at(ring.time(5000)), 5000);
  assert.equal(ring.at(-1), ring.first);
  assert.equal(ring.at(1e9), ring.end);
});

test("angles come back as they went in", () => {
  const ring = new HopRing(2, 1, 16000, 128);
  ring.push({ t: 1, tracks: [track(1, 5, [-123, 41])], potentials: [[...direction(12, -30), 0.5]] });
  assert.ok(Math.abs(ring.az[ring.cell(0, 1)]! + 123) < 1e-4);
  assert.ok(Math.abs(ring.el[ring.cell(0, 1)]! - 41) < 1e-4);
  assert.equal(ring.id[ring.cell(0, 0)], 0);
  assert.ok(Math.abs(ring.peakEl[ring.peak(0, 0)]! + 30) < 1e-4);
});

test("a slot that the run did not announce breaks nothing", () => {
  const ring = new HopRing(1, 0, 16000, 128);
  ring.push({ t: 1, tracks: [track(9, 5, [0, 0])], potentials: [[1, 0, 0, 1]] });
  assert.equal(ring.id[ring.cell(0, 0)], 0);
});

for (const pixels of [2000, 40]) {
  test(`no segment joins both ends of the circle at ${pixels} pixels a second`, () => {
    const around = Array.from({ length: 600 }, (_, k) => ((k * 7 + 180) % 360) - 180);
    for (const turns of [around, around.toReversed()]) {
      const segments = lines(ringOf(turns), pixels);
      const longest = Math.max(...segments.filter((s) => Math.abs(s.x1 - s.x0) > 1e-9).map((s) => Math.abs(s.y1 - s.y0)));
      assert.ok(longest <= 180, `${longest}`);
      const crossing = segments.filter((s) => s.y0 * s.y1 < 0 && Math.abs(s.y0) > 170 && Math.abs(s.y1) > 170);
      assert.deepEqual(crossing, []);
      assert.ok(segments.some((s) => Math.abs(s.y1) === 180), "the line goes to the edge");
    }
  });
}

test("many hops in one column of pixels: each extreme is drawn", () => {
  const azimuths = Array.from({ length: 1000 }, () => 10);
  azimuths[500] = 77;
  azimuths[501] = -55;
  const ys = lines(ringOf(azimuths), 5).flatMap((s) => [s.y0, s.y1]);
  assert.ok(Math.abs(Math.max(...ys) - 77) < 1e-3);
  assert.ok(Math.abs(Math.min(...ys) + 55) < 1e-3);
});

test("a line ends with its voice, and where hops are missing", () => {
  const ring = ringOf([10, 10, 10, null, 10, 10]);
  assert.deepEqual(pieces(ring, 0, 0, ring.end, () => true).map(({ from, to }) => [from, to]), [[0, 3], [4, 6]]);
  const holes = new HopRing(1, 0, 16000, 128);
  for (const t of [1, 2, 3, 40, 41]) holes.push({ t, tracks: [track(0, 1, [0, 0])] });
  assert.deepEqual(pieces(holes, 0, 0, holes.end, () => true).map(({ from, to }) => [from, to]), [[0, 3], [3, 5]]);
  const other = new HopRing(1, 0, 16000, 128);
  other.push({ t: 1, tracks: [track(0, 1, [0, 0])] });
  other.push({ t: 2, tracks: [track(0, 2, [0, 0])] });
  assert.deepEqual(pieces(other, 0, 0, 2, () => true).map(({ id }) => id), [1, 2]);
});

test("a voice of one hop is seen", () => {
  assert.equal(lines(ringOf([null, 30, null]), 100).length, 1);
});
