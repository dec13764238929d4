// SPDX-License-Identifier: MIT
// Every page beside Live, in both themes, empty and full, small, large and in French.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { axeFaults, useStudio } from "../support/browser.mjs";
import { audio, hello, hops, kEngine, track } from "../support/fixtures.mjs";
import { sessionFile } from "../support/mcap.mjs";
import { emptyDaemon, fullDaemon, serveFiles } from "../support/scenes.mjs";

const studio = useStudio();
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const kRoutes = [
  { route: "recordings", ready: ".recording" },
  { route: "replay", ready: ".session" },
  { route: "configuration", ready: ".facts" },
  { route: "configuration?tab=form", ready: ".section" },
  { route: "configuration?tab=text", ready: ".gutter li" },
  { route: "health", ready: ".figure" },
];

async function openAll(page) {
  await page.evaluate(() => {
    for (const details of document.querySelectorAll("details.section")) details.open = true;
  });
}

for (const theme of ["light", "dark", "contrast"]) {
  test(`axe finds nothing on any page, ${theme}`, async () => {
    const { daemon } = fullDaemon();
    const prepare = async (page) => {
      await serveFiles(page);
      await page.addInitScript((name) => localStorage.setItem("odas.theme", JSON.stringify(name)), theme);
    };
    const { page, origin, done } = await studio.open({ route: "recordings", daemon, prepare });
    for (const { route, ready } of kRoutes) {
      await page.goto(`${origin}/#/${route}`);
      await page.waitForSelector(ready);
      await openAll(page);
      assert.deepEqual(await axeFaults(page, axe), [], route);
    }
    await page.goto(`${origin}/#/replay?session=a.mcap`);
    await page.waitForSelector(".timeline");
    assert.deepEqual(await axeFaults(page, axe), [], "an open session");
    await done();
  });
}

test("axe finds nothing where there is nothing", async () => {
  const { daemon } = emptyDaemon();
  const { page, origin, done } = await studio.open({ route: "recordings", daemon });
  for (const route of ["recordings", "replay", "configuration", "health"]) {
    await page.goto(`${origin}/#/${route}`);
    await page.waitForSelector("main :is(.empty, .first-run)");
    assert.deepEqual(await axeFaults(page, axe), [], route);
  }
  await done();
});

test("320 pixels wide, and letters twice as large: nothing runs off the side of any page", async () => {
  const { daemon } = fullDaemon();
  const { page, origin, done } = await studio.open({ route: "recordings", daemon, prepare: serveFiles, viewport: { width: 320, height: 640 } });
  const wide = () => page.evaluate(() => document.documentElement.scrollWidth);
  for (const { route, ready } of [...kRoutes, { route: "replay?session=a.mcap", ready: ".timeline" }]) {
    await page.setViewportSize({ width: 320, height: 640 });
    await page.goto(`${origin}/#/${route}`);
    await page.waitForSelector(ready);
    await openAll(page);
    assert.ok((await wide()) <= 320, `${route}: ${await wide()}`);
    // 200 % zoom of a window of 1280: 640 CSS pixels.
    await page.setViewportSize({ width: 640, height: 400 });
    assert.ok((await wide()) <= 640, `${route}, zoomed: ${await wide()}`);
  }
  await done();
});

test("a French browser gets French pages, and radians where they are wanted", async () => {
  const { daemon } = fullDaemon();
  const prepare = (page) => page.addInitScript(() => localStorage.setItem("odas.angle", JSON.stringify("rad")));
  const { page, origin, done } = await studio.open({ route: "recordings", daemon, locale: "fr-CA", prepare });
  await page.getByRole("heading", { name: "Enregistrements", level: 1 }).waitFor();
  assert.equal(await page.evaluate(() => document.documentElement.lang), "fr");
  await page.getByText("+0,59 rad / +0,21 rad").waitFor();
  for (const [route, words] of [["replay", "De cet ordinateur"], ["configuration", "Ce que cela donne"], ["health", "Où va le temps d’une trame"]]) {
    await page.goto(`${origin}/#/${route}`);
    await page.getByText(words).waitFor();
  }
  await done();
});

test("health says the state and its reason, all figures, and finds lines of the log", async () => {
  const { daemon } = fullDaemon();
  daemon.greeting[1] = { type: "engine", state: "failed", what: "the device is gone (exit code 1)" };
  const { page, done } = await studio.open({ route: "health", daemon });
  await page.locator(".engine-what").getByText("the device is gone (exit code 1)").waitFor();
  assert.equal(await page.locator(".figure").count(), 16);
  await page.getByLabel("Level").selectOption("error");
  assert.equal(await page.locator(".log-lines li").count(), 1);
  await page.getByLabel("Level").selectOption("");
  await page.getByLabel("Search the log").fill("opened");
  assert.equal(await page.locator(".log-lines li").count(), 1);
  await page.locator(".engine-panel").getByRole("button", { name: "Start", exact: true }).click();
  await page.locator(".engine-panel").getByRole("button", { name: "Restart" }).click();
  assert.deepEqual(daemon.heard.filter((one) => one.method?.startsWith("engine.")).map((one) => one.method), ["engine.start", "engine.restart"]);
  await done();
});

test("the spectrogram shows the chosen voice beside the microphone", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await studio.open({ daemon });
  daemon.hops(20, () => [track(0, 12, [30, 0])]);
  await page.waitForSelector('[data-voice="12"]');
  await page.getByRole("button", { name: "Spectrogram" }).click();
  await page.getByText("Choose a voice to see it").waitFor();
  await page.locator("body").press("ArrowDown");
  await page.waitForSelector(".spectrogram canvas");
  for (let i = 0; i < 100 && daemon.subscription.audio.length < 2; ++i) await page.waitForTimeout(50);
  assert.deepEqual(daemon.subscription.audio, [{ stream: "separated", track: 12 }, { stream: "raw", mic: 1 }]);
  const tone = (hz) => (_, i) => 8000 * Math.sin((2 * Math.PI * hz * i) / 16000);
  for (let block = 0; block < 10; ++block) {
    daemon.send(audio({ stream: 0, source: 12, first: block * 512, samples: Array.from({ length: 512 }, tone(1000)) }));
    daemon.send(audio({ stream: 2, source: 1, first: block * 512, samples: Array.from({ length: 512 }, tone(3000)) }));
    daemon.send(audio({ stream: 0, source: 13, first: block * 512, samples: Array.from({ length: 512 }, tone(5000)) }));
  }
  await page.waitForSelector('.spectrogram canvas[data-loudest="32"]');
  await page.waitForSelector('.spectrogram canvas[data-loudest="96"]');
  await page.getByRole("button", { name: "Spectrogram" }).click();
  for (let i = 0; i < 100 && daemon.subscription.audio.length > 0; ++i) await page.waitForTimeout(50);
  assert.deepEqual(daemon.subscription.audio, [], "who does not look gets no sound");
  await done();
});

test("the camera has a mark where a voice is, and none for one behind it", async () => {
  const camera = { url: "/camera.svg", width: 640, height: 480, fx: 550, fy: 550, cx: 320, cy: 240, position: [0, 0, 0], rotation: [0, 0, 0] };
  const { daemon } = fullDaemon();
  daemon.greeting = [hello({ camera }), kEngine];
  const picture = '<svg xmlns="http://www.w3.org/2000/svg" width="640" height="480"/>';
  const prepare = (page) => page.route("**/camera.svg", (route) => route.fulfill({ body: picture, contentType: "image/svg+xml" }));
  const { page, done } = await studio.open({ daemon, prepare });
  daemon.send(hops(1, 20, () => [track(0, 12, [10, 0]), track(1, 13, [-170, 0])]));
  await page.waitForSelector('[data-voice="12"]');
  await page.getByRole("button", { name: "Camera" }).click();
  await page.waitForSelector('[data-track="12"]');
  assert.equal(await page.locator("[data-track]").count(), 1);
  const x = await page.$eval('[data-track="12"]', (mark) => Number(/translate\(([\d.]+)/.exec(mark.getAttribute("transform"))[1]));
  assert.ok(Math.abs(x - (320 - 550 * Math.tan((10 * Math.PI) / 180))) < 0.5);
  await page.getByText("Not in the picture: 13").waitFor();
  await done();
});

test("a session opens by being dropped", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await studio.open({ route: "replay", daemon });
  await page.waitForSelector(".drop");
  const bytes = [...sessionFile({ seconds: 0.5, audioToo: false })];
  await page.evaluate((content) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([new Uint8Array(content)], "dropped.mcap"));
    document.querySelector(".drop").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, bytes);
  await page.getByRole("heading", { name: "dropped.mcap" }).waitFor();
  await done();
});
