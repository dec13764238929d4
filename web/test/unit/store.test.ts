// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import type { Message } from "../../src/socket/messages";
import { waitBefore } from "../../src/socket/socket";
import { Store } from "../../src/store/store";
import { hello, hops, kEngine, run, track } from "../support/fixtures.mjs";

function started(fields = {}): Store {
  const store = new Store();
  store.receive(hello(fields) as Message, 0);
  store.receive(kEngine as Message, 0);
  return store;
}

const one = (t: number) => [track(0, 12, [t % 90, 0])];

test("hops make a live store, silence a stale one, and nobody is there after a while", () => {
  const store = started();
  store.receive(hops(1, 10, one) as Message, 100);
  assert.equal(store.link.value, "live");
  assert.equal(store.liveTracks().length, 1);
  store.tick(1050);
  assert.equal(store.link.value, "live");
  store.tick(1200);
  assert.equal(store.link.value, "stale");
  store.tick(3200);
  assert.deepEqual(store.liveTracks(), []);
});

test("nothing of one run is seen in the next", () => {
  const store = started();
  store.receive(hops(1, 10, one) as Message, 0);
  store.receive({ type: "transcript", track: 12, text: "hello", final: true }, 0);
  const epoch = store.epoch.value;
  store.receive(hello({ run: run({ id: 2 }) }) as Message, 0);
  assert.equal(store.ring.end, 0);
  assert.deepEqual(store.liveTracks(), []);
  assert.equal(store.transcripts.value.size, 0);
  assert.equal(store.epoch.value, epoch + 1);
  store.receive({ ...hops(11, 5, one), run: 1 } as Message, 0);
  assert.equal(store.ring.end, 0, "late hops of the run before");
});

test("the same run after a lost connection goes on where it was", () => {
  const store = started();
  store.receive(hops(1, 10, one) as Message, 0);
  store.disconnected();
  assert.equal(store.link.value, "connecting");
  store.attempts.value = 1;
  assert.equal(store.link.value, "offline");
  assert.deepEqual(store.liveTracks(), []);
  store.receive(hello() as Message, 0);
  store.receive(hops(60, 5, one) as Message, 0);
  assert.equal(store.ring.end, 15);
});

test("hops that count from the start again clear what was", () => {
  const store = started();
  store.receive(hops(1000, 10, one) as Message, 0);
  store.receive(hops(1, 3, one) as Message, 0);
  assert.equal(store.ring.end, 3);
});

test("daemons that are older or newer are said so, and missing fields break nothing", () => {
  const store = new Store();
  store.receive({ type: "hello" } as Message, 0);
  assert.equal(store.stranger.value, "older");
  assert.equal(store.link.value, "still");
  store.receive({ type: "hello", protocol: 3, run: { id: 1 } } as Message, 0);
  assert.equal(store.stranger.value, "newer");
  store.receive({ type: "hops", hops: [{ t: 4 }, { t: 5, tracks: [[0, 3, 1, 0, 0, 1]] }] } as Message, 0);
  store.receive({ type: "novelty" } as unknown as Message, 0);
  assert.equal(store.link.value, "live");
  assert.equal(store.liveTracks()[0]!.level, null);
});

test("a text that is not final gives way to the next", () => {
  const store = started();
  const say = (text: string, final: boolean) => store.receive({ type: "transcript", track: 12, text, final }, 0);
  say("turn", false);
  say("turn on", false);
  say("turn on the light", true);
  say("and", false);
  assert.deepEqual(store.transcripts.value.get(12)!.map((one) => one.text), ["turn on the light", "and"]);
});

test("tries to connect come later and later, and never later than six seconds", () => {
  assert.ok(waitBefore(1, 0.5) === 250 && waitBefore(2, 0.5) === 500);
  for (let attempt = 1; attempt < 2000; attempt++) assert.ok(waitBefore(attempt, 0.999) <= 6250);
});
