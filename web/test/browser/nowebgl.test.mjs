// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { pixelsOf, useStudio } from "../support/browser.mjs";
import { kNoWebGL } from "../support/chromium.mjs";
import { track } from "../support/fixtures.mjs";

const studio = useStudio({ flags: kNoWebGL });

test("without WebGL the same is shown on a flat map, and 3-D is not even loaded", async () => {
  const { page, daemon, done } = await studio.open({ query: "?test=1", colorScheme: "light" });
  const requests = [];
  page.on("request", (request) => requests.push(request.url()));
  daemon.feed({ tracks: () => [track(0, 11, [60, 20])] });
  await page.waitForSelector('[data-stage="flat"]');
  await page.getByText("3-D is not available").waitFor();
  await page.waitForFunction(() => globalThis.odasTest.probes.sphere().balls.length === 1);
  const ball = await page.evaluate(() => globalThis.odasTest.probes.sphere().balls[0]);
  const color = await page.locator('[data-voice="11"]').evaluate((card) => card.style.getPropertyValue("--track"));
  const found = await pixelsOf(page, ".sphere-box", color);
  assert.ok(found.count > 60, `${found.count}`);
  assert.ok(Math.hypot(found.x - ball.x, found.y - ball.y) < 8, JSON.stringify({ found, ball }));
  assert.deepEqual(requests.filter((url) => url.includes("scene")), []);
  await done();
});
