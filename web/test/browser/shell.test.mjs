// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { FakeDaemon } from "../support/daemon.mjs";
import { hello } from "../support/fixtures.mjs";

const studio = useStudio();

test("the page loads, asks nobody but its daemon, and says that hops come", async () => {
  const { page, daemon, done } = await studio.open();
  daemon.hops(10);
  await page.waitForSelector('[data-state="live"]');
  assert.equal(daemon.heard[0].type, "subscribe");
  await done();
});

test("every route opens", async () => {
  const { page, done } = await studio.open();
  for (const route of ["recordings", "replay", "configuration", "health", "live"]) {
    await page.click(`nav a[href="#/${route}"]`);
    await page.waitForSelector(`nav a[href="#/${route}"][aria-current="page"]`);
    await page.waitForSelector("main :is(h1, h2)");
  }
  await done();
});

test("a daemon of another protocol is said so, and what it says is shown", async () => {
  const daemon = new FakeDaemon();
  daemon.greeting = [hello({ protocol: 7, novelty: true })];
  const { page, done } = await studio.open({ daemon });
  await page.getByText("newer than this page").waitFor();
  daemon.send({ type: "unheard_of", x: 1 });
  daemon.hops(3);
  await page.waitForSelector('[data-state="live"]');
  await done();
});
