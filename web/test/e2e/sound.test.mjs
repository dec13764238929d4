// SPDX-License-Identifier: MIT
// Sound all the way: engine, protocol, page, against the recording that the engine makes of the same voice.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { kListening } from "../support/chromium.mjs";
import { missing, startDaemon, temporaryFolder } from "../support/real_daemon.mjs";
import { piecesAgainst, samplesOf } from "../support/sound.mjs";

const studio = useStudio({ flags: kListening });
const folder = temporaryFolder();
after(() => folder.remove());

const kRate = 16000;
const kSeconds = 60;
/** Of what was played the page keeps the first half minute for us. */
const kKept = 30;
const skip = missing || (process.env.ODAS_SOAK ? false : "a minute of sound, heard in real time: make soak runs it");
/** Other programs of this computer may take it away for longer than sound can wait: so often it is tried again. */
const kTries = 3;

/** One command to the daemon, by a connection of its own from within the page. */
const call = (page, method, params) =>
  page.evaluate(async ([method, params]) => {
    const socket = new WebSocket(`ws://${location.host}/api/v1/live`);
    await new Promise((resolve) => (socket.onopen = resolve));
    return new Promise((resolve) => {
      socket.onmessage = ({ data }) => {
        const message = typeof data === "string" ? JSON.parse(data) : {};
        if (message.type !== "reply") return;
        socket.close();
        resolve(message.result ?? message.error);
      };
      socket.send(JSON.stringify({ id: 1, method, params }));
    });
  }, [method, params]);

const audio = (page) => page.evaluate(() => globalThis.odasTest.probes.audio());

/** Listens for `kSeconds` from now on: what was played, and how that went. */
async function listen(page) {
  await page.evaluate(() => globalThis.odasTest.probes.clearTap());
  const before = (await audio(page)).report;
  await page.waitForFunction((count) => globalThis.odasTest.probes.audio().report.played >= count, before.played + kRate * kSeconds, { timeout: 200000, polling: 200 });
  const latency = Number.parseFloat(await page.locator("[data-latency]").first().textContent());
  const { report } = await audio(page);
  return { underruns: report.underruns - before.underruns, latency, heard: await page.evaluate(() => globalThis.odasTest.probes.tap()) };
}

test("what is heard in the page is the recording of the same voice", { skip, timeout: 600000 }, async (context) => {
  const daemon = await startDaemon({ recordings: folder.path });
  context.after(() => daemon.kill("SIGKILL"));
  // What is drawn small is drawn fast.
  const { page, done } = await studio.open({ url: `http://127.0.0.1:${daemon.port}`, query: "?test=1", viewport: { width: 400, height: 500 } });
  await page.waitForSelector("[data-voice]");
  // A fixed direction is followed for ever: the sources of the sample end with it.
  await call(page, "targets.set", { add: [{ tag: "desk", direction: [0.55, 0.66, 0.5] }] });
  const card = page.locator("[data-voice]", { hasText: "desk" }).first();
  await card.waitFor();
  const id = await card.getAttribute("data-voice");
  await card.getByRole("button", { name: "Record", exact: true }).click();
  await card.getByRole("button", { name: "Stop recording" }).waitFor();
  await card.getByRole("button", { name: "Listen" }).click();
  await page.waitForFunction(() => globalThis.odasTest.probes.audio().report.played > 0);
  let now = await listen(page);
  for (let tries = 1; now.underruns > 0 && tries < kTries; tries++) now = await listen(page);
  const list = await call(page, "record.stop", { all: true });
  const name = list.names.find((one) => one.includes(`source_${id}`));
  assert.ok(name, JSON.stringify(list));
  const pieces = piecesAgainst(now.heard, samplesOf(readFileSync(join(folder.path, name))), kRate / 2).sort((a, b) => a - b);
  const median = pieces[Math.floor(pieces.length / 2)];
  context.diagnostic(`SI-SDR of ${pieces.length} half seconds: median ${median.toFixed(0)} dB, least ${pieces[0].toFixed(0)} dB; ${now.underruns} underruns; ${now.latency} ms behind`);
  assert.ok(pieces.length >= 2 * kKept - 3, `${pieces.length} pieces`);
  assert.ok(median > 40, `${median} dB`);
  assert.equal(now.underruns, 0);
  assert.ok(now.latency > 0 && now.latency < 250, `${now.latency} ms`);
  await done();
  assert.equal(await daemon.kill("SIGINT"), 0);
});
