// SPDX-License-Identifier: MIT
// Sound in the page, by both ways to the loudspeaker.
import assert from "node:assert/strict";
import { networkInterfaces } from "node:os";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { kListening } from "../support/chromium.mjs";
import { FakeDaemon } from "../support/daemon.mjs";
import { audio, hello, kHop, kRate, run } from "../support/fixtures.mjs";
import { voices } from "../support/voices.mjs";

const studio = useStudio({ flags: kListening });

const kHertz = { 11: 440, 12: 700 };

/** A daemon that sends what is subscribed at the pace of the clock: a tone for each voice. */
function singing(daemon) {
  const begin = performance.now();
  let sent = 0;
  daemon.timer = setInterval(() => {
    const due = Math.floor(((performance.now() - begin) / 1000) * kRate / kHop);
    const [wish] = daemon.subscription?.audio ?? [];
    for (; sent < due; sent++) {
      if (sent % 4 === 0) daemon.hops(4, voices(2));
      if (!wish) continue;
      const source = wish.track ?? wish.mic;
      const samples = Array.from({ length: kHop }, (_, k) => tone(sent * kHop + k, kHertz[source] ?? 300));
      daemon.send(audio({ stream: wish.stream === "raw" ? 2 : 0, source, first: sent * kHop, samples }));
    }
  }, 15);
}

const tone = (index, hertz) => 9830 * Math.sin((2 * Math.PI * hertz * index) / kRate);

const look = (page) => page.evaluate(() => globalThis.odasTest.probes.audio());
const tap = (page) => page.evaluate(() => globalThis.odasTest.probes.tap());

async function heard(page, samples) {
  await page.waitForFunction((count) => globalThis.odasTest.probes.audio().report.played >= count, samples, { timeout: 90000, polling: 100 });
  return look(page);
}

/** dB of `samples` against the closest sine of `hertz`. */
function likeness(samples, hertz) {
  let re = 0;
  let im = 0;
  let all = 0;
  samples.forEach((value, k) => {
    re += value * Math.cos((2 * Math.PI * hertz * k) / kRate);
    im += value * Math.sin((2 * Math.PI * hertz * k) / kRate);
    all += value * value;
  });
  const explained = (2 * (re * re + im * im)) / samples.length;
  return 10 * Math.log10(explained / Math.max(1e-12, all - explained));
}

async function open(options = {}) {
  const daemon = new FakeDaemon();
  daemon.greeting[0] = hello({ run: run() });
  const opened = await studio.open({ query: "?test=1", daemon, viewport: { width: 360, height: 500 }, ...options });
  singing(daemon);
  await opened.page.waitForSelector('[data-voice="12"]');
  return opened;
}

const listen = (page, id) => page.locator(`[data-voice="${id}"]`).getByRole("button", { name: "Listen" }).click();

/** The likeness of the quarter of a second that is most like it: this computer has others to serve too, and may have stumbled. */
function best(samples, hertz) {
  const all = [];
  for (let k = 0; k + 4000 <= samples.length; k += 500) all.push(likeness(samples.slice(k, k + 4000), hertz));
  return Math.max(...all);
}

test("on this computer a worklet plays: the samples that were sent, and how late is said", async () => {
  const { page, done } = await open();
  await listen(page, 11);
  const now = await heard(page, kRate);
  assert.equal(now.path, "worklet");
  assert.equal(now.rate, kRate);
  assert.equal(now.state, "running");
  await page.locator("[data-latency]").waitFor();
  const samples = await tap(page);
  assert.ok(best(samples, 440) > 40, `${best(samples, 440)} dB, ${now.report.underruns} underruns`);
  assert.ok(best(samples, 700) < 0);
  await done();
});

const address = Object.values(networkInterfaces()).flat().find((one) => one.family === "IPv4" && !one.internal)?.address;

test("in a plain network, where there is no worklet, scheduled buffers play", { skip: address ? false : "this computer has no address but its own" }, async () => {
  const { page, done } = await open({ host: address });
  assert.equal(await page.evaluate(() => isSecureContext), false);
  await listen(page, 12);
  const now = await heard(page, kRate);
  assert.equal(now.path, "buffers");
  assert.ok(now.time > 0.5);
  const samples = await tap(page);
  assert.ok(best(samples, 700) > 40, `${best(samples, 700)} dB, ${now.report.underruns} underruns`);
  await done();
});

test("another voice is taken up without a click; no voice is heard under another's name", async () => {
  const { page, daemon, done } = await open();
  // Pressing may take a while, too: what is counted comes from then on.
  const listenFor = async (id, count) => {
    await listen(page, id);
    while (daemon.subscription.audio[0]?.track !== id) await page.waitForTimeout(20);
    return (await heard(page, (await look(page)).report.played + count)).report;
  };
  // Other programs of this computer may take it away for longer than sound can wait: then the change is heard again.
  for (let tries = 0, gaps = 1; tries < 5 && gaps > 0; tries++) {
    const before = await listenFor(11, 8000);
    await page.evaluate(() => globalThis.odasTest.probes.clearTap());
    const after = await listenFor(12, 12000);
    gaps = after.underruns - before.underruns;
  }
  assert.deepEqual(daemon.subscription.audio, [{ stream: "separated", track: 12 }]);
  const samples = await tap(page);
  const steepest = 0.3 * 2 * Math.sin((Math.PI * 700) / kRate);
  const steps = samples.slice(1).map((value, k) => Math.abs(value - samples[k]));
  assert.ok(Math.max(...steps) < 1.6 * steepest, `${Math.max(...steps)} of ${steepest}`);
  assert.ok(best(samples, 700) > 40, `${best(samples, 700)} dB of ${samples.length} samples`);
  const heardThen = [];
  for (let k = 0; k + 400 <= samples.length; k += 400) {
    const piece = samples.slice(k, k + 400);
    for (const id of [11, 12]) if (likeness(piece, kHertz[id]) > 3) heardThen.push(id);
  }
  assert.ok(heardThen.lastIndexOf(11) < heardThen.indexOf(12), heardThen.join(" "));
  await page.keyboard.press("l");
  await page.waitForSelector(".listenbar", { state: "detached" });
  assert.deepEqual(daemon.subscription.audio, []);
  await done();
});

test("a microphone can be heard too, and the volume is remembered", async () => {
  const { page, daemon, done } = await open();
  daemon.send({ type: "meters", t: 1, mics: [[-40, -30, 0], [-40, -30, 0]] });
  await page.getByRole("button", { name: "Listen: Microphone 2" }).click();
  await heard(page, 2000);
  assert.deepEqual(daemon.subscription.audio, [{ stream: "raw", mic: 2 }]);
  await page.getByLabel("Volume").fill("0.5");
  assert.equal(await page.evaluate(() => localStorage.getItem("odas.volume")), "0.5");
  await page.getByRole("button", { name: "Mute", exact: true }).first().click();
  await page.locator(".listenbar").getByRole("button", { name: "Stop listening" }).click();
  await page.waitForSelector(".listenbar", { state: "detached" });
  await done();
});
