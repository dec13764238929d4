// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { Replayer } from "../../src/lib/replayer";
import { readSession } from "../../src/lib/session";
import { toCsv, toJsonl, toRttm } from "../../src/lib/session_export";
import { readSound } from "../../src/lib/sound_index";
import type { Run, WireHop } from "../../src/socket/messages";
import { chunk, mcap, record, sessionFile, sessionMessages } from "../support/mcap.mjs";
import { run } from "../support/fixtures.mjs";

const recorded: WireHop[] = sessionMessages().filter((one: any) => one.topic === "hops").map((one: any) => one.data);

class Watcher {
  runs: Run[] = [];
  heard: WireHop[] = [];
  begin(next: Run) {
    this.runs.push(next);
    this.heard = [];
  }
  hops(hops: WireHop[]) {
    this.heard.push(...hops);
  }
}

for (const chunked of [false, true]) {
  test(`a session ${chunked ? "in chunks" : "of plain records"} is read whole`, async () => {
    const session = await readSession("a.mcap", new Blob([sessionFile({ chunked })]));
    assert.equal(session.fault, null);
    assert.equal(session.unread, 0);
    assert.equal(session.hops.length, 500);
    assert.ok(Math.abs(session.seconds - 4) < 1e-9);
    assert.equal(session.parts[0]!.run.name, "fixture");
    assert.equal(new Date(session.start).toISOString(), "2026-01-31T12:00:00.125Z");
    assert.deepEqual(session.spans.map(({ id, kind }) => [id, kind]), [[12, 2], [13, 1]]);
    assert.ok(Math.abs(session.spans[1]!.from - 1) < 1e-9);
    assert.equal(session.log[0]!.what.text, "the end");
  });

  test(`the sound of a voice is where it was ${chunked ? "in chunks" : ""}`, async () => {
    const session = await readSession("a.mcap", new Blob([sessionFile({ chunked })]));
    const voice = session.sound.list().find((one) => one.stream === "separated")!;
    const from = 100 * 128 + 700;
    const sound = await readSound(session.file, voice, from, 1000);
    sound.forEach((sample, k) => {
      const want = Math.round(8000 * Math.sin((2 * Math.PI * 440 * (from + k)) / 16000)) / 32768;
      assert.ok(Math.abs(sample - want) < 1e-6, `sample ${k}`);
    });
  });
}

test("what lies before and behind a voice is silence", async () => {
  const session = await readSession("a.mcap", new Blob([sessionFile()]));
  const voice = session.sound.list()[0]!;
  assert.ok((await readSound(session.file, voice, 0, 500)).every((sample) => sample === 0));
});

test("replayed frames are the recorded frames, each once and in order, at any pace", async () => {
  const session = await readSession("a.mcap", new Blob([sessionFile()]));
  const watcher = new Watcher();
  const replayer = new Replayer(session, watcher);
  for (let i = 0; !replayer.ended; ++i) {
    replayer.speed = [0.25, 1, 8, 2][i % 4]!;
    replayer.advance(((i * 7919) % 50) / 1000);
  }
  assert.equal(watcher.runs.length, 1);
  assert.deepEqual(watcher.heard, recorded);
});

test("a jump shows the past of the place, and goes on from there without a doubled or a lost hop", async () => {
  const session = await readSession("a.mcap", new Blob([sessionFile()]));
  const watcher = new Watcher();
  const replayer = new Replayer(session, watcher);
  replayer.advance(3);
  replayer.seek(1);
  assert.equal(watcher.heard.at(-1)!.t, 101 + 125);
  replayer.advance(0.5);
  assert.deepEqual(watcher.heard, recorded.slice(0, 126 + 62));
  replayer.step(1);
  assert.equal(watcher.heard.at(-1)!.t, 101 + 188);
  replayer.step(-1);
  assert.equal(watcher.heard.at(-1)!.t, 101 + 187);
});

test("a loop goes back from B to A", async () => {
  const session = await readSession("a.mcap", new Blob([sessionFile()]));
  const replayer = new Replayer(session, new Watcher());
  replayer.loop = { a: 1, b: 2 };
  replayer.seek(1.9);
  assert.equal(replayer.advance(0.2), false);
  assert.equal(replayer.position, 1);
  replayer.seek(3);
  replayer.advance(0.5);
  assert.equal(replayer.position, 3.5, "beyond the loop it plays on");
});

test("another run within a session begins anew", async () => {
  const start = 1_000_000_000n;
  const hop = (t: number) => ({ t, tracks: [], potentials: [] });
  const file = mcap([
    { topic: "run", at: start, data: run({ id: 1, name: "one" }) },
    { topic: "hops", at: start, data: hop(50) },
    { topic: "hops", at: start + 8_000_000n, data: hop(51) },
    { topic: "run", at: start + 1_000_000_000n, data: run({ id: 2, name: "two" }) },
    { topic: "hops", at: start + 1_000_000_000n, data: hop(1) },
  ]);
  const session = await readSession("b.mcap", new Blob([file]));
  const watcher = new Watcher();
  const replayer = new Replayer(session, watcher);
  replayer.advance(10);
  assert.deepEqual(watcher.runs.map(({ name }) => name), ["one", "two"]);
  assert.deepEqual(watcher.heard, [hop(1)]);
  assert.equal(session.hops.seconds(2), 1);
});

test("a file that was cut anywhere is read as far as it goes", async () => {
  const whole = sessionFile({ seconds: 0.2 });
  let most = 0;
  for (let cut = 8; cut < whole.length - 100; cut += 37) {
    const session = await readSession("c.mcap", new Blob([whole.subarray(0, cut)]));
    assert.equal(session.fault, "cut");
    assert.ok(session.hops.length >= most, "more bytes, no fewer hops");
    most = session.hops.length;
  }
  assert.equal(most, 25);
});

test("a file without its end is said to be cut", async () => {
  const session = await readSession("c.mcap", new Blob([sessionFile({ seconds: 1, footer: false })]));
  assert.equal(session.fault, "cut");
  assert.equal(session.hops.length, 125);
});

test("something else is no session, and a compressed one is said to be so", async () => {
  assert.equal((await readSession("d", new Blob(["RIFF....WAVE, and more of it"]))).fault, "not_mcap");
  assert.equal((await readSession("d", new Blob([]))).fault, "not_mcap");
  const head = sessionFile({ seconds: 0.1 }).subarray(0, 8);
  const packed = Buffer.concat([head, record(1), chunk([], "zstd")]);
  assert.equal((await readSession("d", new Blob([packed]))).fault, "compressed");
});

test("bytes that mean nothing never throw", async () => {
  const whole = sessionFile({ seconds: 0.3 });
  for (let i = 0; i < 300; ++i) {
    const bad = Buffer.from(whole);
    for (let k = 0; k < 4; ++k) bad[8 + ((i * 7919 + k * 104729) % (bad.length - 8))] = (i * 31 + k * 17) & 255;
    await readSession("e.mcap", new Blob([bad]));
  }
});

test("exports say every track of every hop", async () => {
  const session = await readSession("my session.mcap", new Blob([sessionFile()]));
  const csv = toCsv(session);
  assert.equal(csv.length, 1 + 500 + 375);
  assert.equal(csv[1], "101,0.000,2026-01-31T12:00:00.125Z,0,12,dynamic,0.7544,0.6330,0.1736,40.00,10.00,0.900,-22.0,speech\n");
  const lines = toJsonl(session);
  assert.equal(lines.length, 500);
  const line = JSON.parse(lines[7]!);
  assert.deepEqual([line.timeStamp, line.time, line.utc, line.src[0].id, line.src[0].class], [108, 0.056, "2026-01-31T12:00:00.181Z", 12, "speech"]);
  assert.deepEqual(toRttm(session), ["SPEAKER my_session 1 0.000 4.000 <NA> <NA> source_12 <NA> <NA>\n"], "13 is no speech");
});
