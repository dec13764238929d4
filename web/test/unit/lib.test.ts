// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { kShapes, makeArray, sharedPlaces } from "../../src/lib/array_templates";
import { bytes, clock } from "../../src/lib/bytes";
import { Fft } from "../../src/lib/fft";
import { FigureHistory } from "../../src/lib/figure_history";
import { heat } from "../../src/lib/heat";
import { look, kViews } from "../../src/lib/orbit";
import { project, readPinhole, type Pinhole } from "../../src/lib/pinhole";
import { exportUrl, filterRecordings, kNoFilter, recordingUrl, zipUrl } from "../../src/lib/recording_list";
import { Spectrum } from "../../src/lib/spectrum";
import { diffLines, hunks } from "../../src/lib/text_diff";
import { direction } from "../../src/store/angles";

const near = (a: number, b: number, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test("the FFT agrees with the sum that it stands for", () => {
  const n = 32;
  const re = Float64Array.from({ length: n }, (_, i) => Math.sin(i * i));
  const im = Float64Array.from({ length: n }, (_, i) => Math.cos(3 * i));
  const [wantRe, wantIm] = [new Float64Array(n), new Float64Array(n)];
  for (let k = 0; k < n; ++k) {
    for (let i = 0; i < n; ++i) {
      const [c, s] = [Math.cos((2 * Math.PI * k * i) / n), -Math.sin((2 * Math.PI * k * i) / n)];
      wantRe[k]! += re[i]! * c - im[i]! * s;
      wantIm[k]! += re[i]! * s + im[i]! * c;
    }
  }
  new Fft(n).transform(re, im);
  for (let k = 0; k < n; ++k) {
    near(re[k]!, wantRe[k]!, 1e-10);
    near(im[k]!, wantIm[k]!, 1e-10);
  }
  assert.throws(() => new Fft(24), RangeError);
});

test("a sine of full scale is 0 dB in its bin, in whatever blocks it comes", () => {
  const spectrum = new Spectrum(512, 256);
  const columns: number[][] = [];
  const sine = Float64Array.from({ length: 4096 }, (_, i) => Math.sin((2 * Math.PI * 32 * i) / 512));
  for (let at = 0; at < sine.length; at += 100) spectrum.push(sine.subarray(at, at + 100), (levels) => columns.push([...levels]));
  assert.equal(columns.length, 15);
  for (const column of columns) {
    near(column[32]!, 0, 0.01);
    assert.ok(column[64]! < -100);
  }
});

const camera: Pinhole = {
  url: "http://camera/stream", width: 640, height: 480, fx: 500, fy: 500, cx: 320, cy: 240, position: [0, 0, 0], rotation: [0, 0, 0],
};

test("what is straight ahead is in the middle; left is left, up is up", () => {
  assert.deepEqual(project(camera, [1, 0, 0]), { x: 320, y: 240 });
  near(project(camera, direction(10, 0))!.x, 320 - 500 * Math.tan(Math.PI / 18), 1e-6);
  assert.ok(project(camera, direction(0, 10))!.y < 240);
});

test("what is behind, beside or outside is not in the picture", () => {
  assert.equal(project(camera, [-1, 0, 0]), null);
  assert.equal(project(camera, [-1, 0.001, 0.001]), null, "the opposite of what is ahead");
  assert.equal(project(camera, [0, 1, 0]), null, "in the plane of the camera");
  assert.equal(project(camera, [0, 0, 1]), null);
  assert.equal(project(camera, direction(40, 0)), null, "outside of the picture");
  assert.equal(project(camera, [0, 0, 0]), null, "nowhere");
  assert.equal(project(camera, [NaN, 0, 0]), null);
});

test("the camera may look elsewhere, be turned and stand elsewhere", () => {
  const turned = { ...camera, rotation: [0, 0, 90] as [number, number, number] };
  const ahead = project(turned, [0, 1, 0])!;
  near(ahead.x, 320, 1e-9);
  near(ahead.y, 240, 1e-9);
  const down = { ...camera, rotation: [0, 30, 0] as [number, number, number] };
  near(project(down, direction(0, -30))!.y, 240, 1e-6);
  const rolled = { ...camera, rotation: [90, 0, 0] as [number, number, number] };
  assert.ok(project(rolled, direction(0, 10))!.x < 320, "rolled to its right, up is at its left");
  const aside = { ...camera, position: [0, 1, 0] as [number, number, number] };
  near(project(aside, [1, 0, 0], 2)!.x, 320 + 250, 1e-9);
  near(project(aside, [1, 0, 0])!.x, 320, 1e-9);
});

test("a camera without numbers gets the usual ones, one without an address is none", () => {
  assert.equal(readPinhole(null), null);
  assert.equal(readPinhole({ url: "" }), null);
  assert.deepEqual(readPinhole({ url: "x", width: 800, rotation: [1, "?", 3] }), {
    url: "x", width: 800, height: 480, fx: 550, fy: 550, cx: 400, cy: 240, position: [0, 0, 0], rotation: [1, 0, 3],
  });
});

test("templates have their microphones where they say", () => {
  const circle = makeArray({ shape: "circular", count: 6, rows: 1, size: 0.05 });
  assert.equal(circle.length, 6);
  for (const { position } of circle) near(Math.hypot(...position), 0.05, 1e-5);
  const line = makeArray({ shape: "linear", count: 5, rows: 1, size: 0.04 });
  assert.deepEqual(line.map(({ position }) => position[1]), [-0.08, -0.04, 0, 0.04, 0.08]);
  const grid = makeArray({ shape: "rectangular", count: 4, rows: 3, size: 0.02 });
  assert.equal(grid.length, 12);
  const solid = makeArray({ shape: "tetrahedron", count: 4, rows: 1, size: 0.06 });
  for (let i = 1; i < 4; ++i) {
    const [a, b] = [solid[0]!.position, solid[i]!.position];
    near(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.06, 1e-4);
  }
  for (const shape of kShapes) assert.deepEqual(sharedPlaces(makeArray({ shape, count: 4, rows: 2, size: 0.03 }).map((mic) => mic.position)), []);
  assert.deepEqual(sharedPlaces([[0, 0, 0], [1, 0, 0], [0, 0, 0]]), [[1, 3]]);
});

test("a view from above has +x to the right and +y up, one from the side +z up", () => {
  const top = look(kViews.top, [1, 0, 0]);
  near(top.x, 1);
  near(look(kViews.top, [0, 1, 0]).y, 1);
  near(look(kViews.front, [0, 0, 1]).y, 1);
  near(look(kViews.front, [1, 0, 0]).depth, 1);
});

test("a diff tells lines that came, went and stayed", () => {
  const lines = diffLines("a\nb\nc\nd", "a\nx\nc\nd\ne");
  assert.deepEqual(lines.map(({ kind, text }) => `${kind[0]}${text}`), ["sa", "rb", "ax", "sc", "sd", "ae"]);
  assert.deepEqual(lines[2], { kind: "added", text: "x", after: 2 });
  assert.deepEqual(hunks(diffLines("a\nb", "a\nb")), []);
  const far = hunks(diffLines([..."abcdefghij"].join("\n"), [..."abcdeXghij"].join("\n")), 1);
  assert.deepEqual(far.map((line) => (line ? line.text : "...")), ["...", "e", "f", "X", "g", "..."]);
});

test("heat goes from dark to bright and takes any number", () => {
  const lightness = (share: number) => heat(share).reduce((sum, c) => sum + c, 0);
  for (let i = 1; i <= 10; ++i) assert.ok(lightness(i / 10) > lightness((i - 1) / 10));
  assert.deepEqual(heat(NaN), heat(0));
  assert.deepEqual(heat(7), heat(1));
});

test("recordings are filtered by kind, stream and every word", () => {
  const all = [
    { name: "a", kind: "track", stream: "separated" as const, track: 12, start: "2026-01-01", label: "Anna" },
    { name: "b", kind: "raw", stream: "raw" as const, start: "2026-01-03" },
    { name: "c", kind: "track", stream: "postfiltered" as const, track: 13, start: "2026-01-02", transcript: "good morning" },
  ];
  const names = (filter: object) => filterRecordings(all, { ...kNoFilter, ...filter }).map(({ name }) => name);
  assert.deepEqual(names({}), ["b", "c", "a"]);
  assert.deepEqual(names({ kind: "track" }), ["c", "a"]);
  assert.deepEqual(names({ stream: "postfiltered" }), ["c"]);
  assert.deepEqual(names({ text: "MORNING good" }), ["c"]);
  assert.deepEqual(names({ text: "anna morning" }), []);
});

test("names go into addresses without becoming a path", () => {
  assert.equal(recordingUrl("../a b&c"), "/api/v1/recordings/..%2Fa%20b%26c");
  assert.equal(zipUrl([]), "/api/v1/recordings.zip");
  assert.equal(zipUrl(["a&b", "c"]), "/api/v1/recordings.zip?name=a%26b&name=c");
  assert.equal(exportUrl("a b.mcap", "csv"), "/api/v1/export/csv?session=a%20b.mcap");
});

test("sizes and lengths are readable", () => {
  const number = (value: number, digits: number) => value.toFixed(digits);
  assert.equal(bytes(999, number), "999\u00a0B");
  assert.equal(bytes(1400000, number), "1.4\u00a0MB");
  assert.equal(clock(187.46, true), "3:07.4");
  assert.equal(clock(3723), "1:02:03");
  assert.equal(clock(0.3, true), "0:00.3");
});

test("figures of health are kept for minutes, and counters are shown as what they grew by", () => {
  const history = new FigureHistory();
  for (let at = 0; at <= 400; at += 1) history.push(at, { type: "health", overruns: at === 400 ? 3 : 2 * at });
  assert.equal(history.rows[0]!.at, 100);
  const growth = history.growth(400, (health) => health.overruns);
  assert.equal(growth[0]!.value, null);
  assert.equal(growth[5]!.value, 2);
  assert.equal(growth.at(-1)!.value, 3, "it began anew");
});
