// SPDX-License-Identifier: MIT
// Sound all the way: engine, protocol, page, against the recording that the engine makes of the same voice.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { FakeDaemon } from "../support/daemon.mjs";
import { noDaemon, startDaemon } from "../support/odas.mjs";
import { bestDecibels, samplesOf } from "../support/sound.mjs";

const studio = useStudio();
// Its minute is for `make soak`; studio_sound_test holds the same over the protocol in `make test`.
const skip = noDaemon || (process.env.ODAS_SOAK ? false : "a minute long: make soak runs it");
const kRate = 16000;
const kSeconds = 60;

/** A page at a daemon of its own; `end` ends both. */
async function open(options = {}) {
  const daemon = await startDaemon(options.args);
  const opened = await studio.open({ url: daemon.url, daemon: new FakeDaemon(), query: "?test=1", ...options });
  const end = async (expected) => {
    await opened.done(expected);
    assert.equal(await daemon.stop(), 0);
  };
  return { ...opened, daemon, end };
}

const firstVoice = (page) => page.locator("[data-voice]").first();

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

test("what is heard in the page is the recording of the same voice", { skip, timeout: 240000 }, async () => {
  const { page, daemon, end } = await open();
  await firstVoice(page).waitFor();
  // A fixed direction is followed for ever: the sources of the sample end with it.
  await call(page, "targets.set", { add: [{ tag: "desk", direction: [0.55, 0.66, 0.5] }] });
  const card = page.locator("[data-voice]", { hasText: "desk" }).first();
  await card.waitFor();
  const id = await card.getAttribute("data-voice");
  await card.getByRole("button", { name: "Record" }).first().click();
  await card.getByRole("button", { name: "Listen" }).click();
  await page.waitForFunction((count) => globalThis.odasTest.probes.audio().report.played >= count, kRate * kSeconds, { timeout: 200000, polling: 200 });
  const now = await audio(page);
  const latency = await page.locator("[data-latency]").first().textContent();
  const heard = await page.evaluate(() => globalThis.odasTest.probes.tap());
  const list = await call(page, "record.stop", { all: true });
  const name = list.names.find((one) => one.includes(`source_${id}`));
  assert.ok(name, JSON.stringify(list));
  const recorded = samplesOf(readFileSync(join(daemon.folder, name)));
  const likeness = bestDecibels(heard, recorded, kRate / 2);
  console.log(`heard in the page against the recording: SI-SDR ${likeness.toFixed(0)} dB, ${now.report.underruns} underruns in ${(now.report.played / kRate).toFixed(1)} s, latency said: ${latency.trim()}`);
  assert.ok(likeness > 40, `${likeness} dB`);
  await end();
});
