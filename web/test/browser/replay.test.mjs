// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { text } from "node:stream/consumers";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { sessionFile } from "../support/mcap.mjs";
import { emptyDaemon, fullDaemon, serveFiles } from "../support/scenes.mjs";

const studio = useStudio();
const position = (page) => page.$eval(".timeline", (element) => Number(element.getAttribute("aria-valuenow")));

function fromDisk(page, buffer, name = "kitchen.mcap") {
  return page.setInputFiles('input[type="file"]', { name, mimeType: "application/octet-stream", buffer });
}

test("a session of the daemon opens, plays, jumps and stops at its end", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await studio.open({ route: "replay", daemon, prepare: serveFiles });
  await page.getByRole("button", { name: "Open Two talkers in the kitchen" }).click();
  await page.waitForSelector(".timeline");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(() => Number(document.querySelector(".timeline").getAttribute("aria-valuenow")) > 0.3);
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await page.focus(".timeline");
  await page.keyboard.press("End");
  assert.equal(await position(page), 4);
  await page.waitForSelector('[data-voice="12"]');
  assert.ok((await page.url()).includes("session=20260131T121500.000Z.mcap"));
  assert.equal(await page.locator(".stage-head a[download]").count(), 3);
  await done();
});

test("a file of this computer opens without a request, and its exports are made in the page", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await studio.open({ route: "replay", daemon });
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await fromDisk(page, sessionFile());
  await page.waitForSelector(".timeline");
  const wait = page.waitForEvent("download");
  await page.locator(".stage-head").getByRole("button", { name: "RTTM" }).click();
  const download = await wait;
  assert.equal(download.suggestedFilename(), "kitchen.rttm");
  assert.equal(await text(await download.createReadStream()), "SPEAKER kitchen 1 0.000 4.000 <NA> <NA> source_12 <NA> <NA>\n");
  assert.deepEqual(asked.filter((url) => url.startsWith("http") && !/chunk-|listen-worklet/.test(url)), []);
  await done();
});

test("a cut file shows what it has and says so; what is no session says that", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await studio.open({ route: "replay", daemon });
  await fromDisk(page, Buffer.from("not a session at all"), "song.mcap");
  await page.getByText("song.mcap is not a session").waitFor();
  const whole = sessionFile();
  await fromDisk(page, whole.subarray(0, Math.round(whole.length / 2)));
  await page.getByText("The end of kitchen.mcap is missing").waitFor();
  await page.waitForSelector(".timeline");
  await done();
});

test("a loop is marked by keys and repeated, faster when asked", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await studio.open({ route: "replay", daemon });
  await fromDisk(page, sessionFile());
  await page.waitForSelector(".timeline");
  const go = async (steps) => {
    await page.focus(".timeline");
    await page.keyboard.press("Home");
    for (let i = 0; i < steps; ++i) await page.keyboard.press("ArrowRight");
  };
  await go(1);
  await page.keyboard.press("a");
  await go(2);
  await page.keyboard.press("b");
  await page.getByText("0:01.0 – 0:02.0").waitFor();
  await page.selectOption(".transport select", "8");
  await go(1);
  await page.keyboard.press(" ");
  await page.waitForTimeout(700);
  await page.keyboard.press(" ");
  const at = await position(page);
  assert.ok(at >= 1 && at <= 2, `${at} is within the loop`);
  await done();
});

test("a daemon that was started with a session leads to it at once", async () => {
  const { daemon } = fullDaemon({ open_session: "20260131T121500.000Z.mcap" });
  const { page, done } = await studio.open({ route: "live", daemon, prepare: serveFiles });
  await page.waitForSelector(".timeline");
  assert.ok(page.url().includes("#/replay?session="));
  await done();
});

test("the voice of a session sounds in step", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await studio.open({ route: "replay", daemon });
  await page.evaluate(() => {
    globalThis.started = [];
    const start = AudioBufferSourceNode.prototype.start;
    AudioBufferSourceNode.prototype.start = function (...args) {
      const data = this.buffer.getChannelData(0);
      globalThis.started.push({ rate: this.playbackRate.value, loud: Math.max(...data.slice(0, 4000)) });
      return start.apply(this, args);
    };
  });
  await fromDisk(page, sessionFile());
  await page.waitForSelector(".timeline");
  await page.locator(".transport select").last().selectOption("separated/12");
  await page.keyboard.press(" ");
  await page.waitForFunction(() => globalThis.started.length >= 2);
  const [first] = await page.evaluate(() => globalThis.started);
  assert.equal(first.rate, 1);
  assert.ok(first.loud > 0.2 && first.loud < 0.26, `the tone has its level: ${first.loud}`);
  await done();
});
