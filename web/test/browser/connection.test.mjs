// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { FakeDaemon } from "../support/daemon.mjs";
import { hello, hops, kEngine, run } from "../support/fixtures.mjs";
import { voices } from "../support/voices.mjs";

const studio = useStudio();

test("a daemon that restarts is found again, and nothing of before is shown", async () => {
  const { page, daemon, done } = await studio.open();
  daemon.hops(10, voices(2));
  await page.waitForSelector('[data-voice="12"]');
  daemon.drop(true);
  await page.waitForSelector('[data-state="offline"]');
  await page.locator(".banner").waitFor();
  assert.equal(await page.locator("[data-voice]").count(), 0);
  daemon.greeting = [hello({ run: run({ id: 1, start: "2026-01-31T13:00:00.000Z" }) }), kEngine];
  daemon.refusing = false;
  await page.waitForSelector('[data-state="live"]');
  assert.equal(await page.locator("[data-voice]").count(), 0);
  daemon.send(hops(1, 5, voices(1)));
  await page.waitForSelector('[data-voice="11"]');
  assert.equal(daemon.connections, 2);
  await done(["WebSocket"]);
});

test("a second without hops is said so, and after three nobody is shown", async () => {
  const { page, daemon, done } = await studio.open();
  daemon.hops(10, voices(2));
  await page.waitForSelector('[data-voice="11"]');
  await page.waitForSelector('[data-state="stale"]');
  await page.waitForFunction(() => document.querySelectorAll("[data-voice]").length === 0);
  daemon.hops(10, voices(2));
  await page.waitForSelector('[data-state="live"]');
  await done();
});

test("an engine that fails is said so with the reason", async () => {
  const { page, daemon, done } = await studio.open();
  daemon.hops(10, voices(1));
  daemon.send({ type: "engine", state: "failed", what: "hw:CARD=Array: no such device. Plug it in, then start." });
  await page.locator(".voices").getByText("Plug it in, then start.").waitFor();
  await page.locator(".voices").getByRole("button", { name: "Start" }).click();
  await daemon.called("engine.start");
  await done();
});

test("without a configuration the next step is a link", async () => {
  const daemon = new FakeDaemon();
  daemon.greeting = [hello({ run: null }), { type: "engine", state: "idle", what: "" }];
  const { page, done } = await studio.open({ daemon });
  assert.equal(await page.getByRole("link", { name: "Choose array and source" }).getAttribute("href"), "#/configuration");
  await done();
});

test("malformed and unknown messages change nothing", async () => {
  const { page, daemon, done } = await studio.open();
  for (const text of ["", "{", "null", "[]", '"x"', "{}", '{"type":"hops"}', '{"type":"meters","mics":[]}', '{"type":"gap"}', '{"type":"reply","id":99}']) daemon.socket.send(text);
  daemon.send(Buffer.from([1, 2, 3]));
  daemon.hops(10, voices(1));
  await page.waitForSelector('[data-voice="11"]');
  await done();
});
