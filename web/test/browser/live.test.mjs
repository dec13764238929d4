// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { pixelsOf, useStudio } from "../support/browser.mjs";
import { FakeDaemon } from "../support/daemon.mjs";
import { beams, hello, kEngine, meters, power, run, track } from "../support/fixtures.mjs";
import { noise, voices } from "../support/voices.mjs";

const studio = useStudio();

/** A page that shows `count` voices, fed until the test ends. */
async function open(count, options = {}) {
  const daemon = options.daemon ?? new FakeDaemon();
  if (!options.daemon) daemon.greeting[0] = hello({ run: run({ slots: 16 }) });
  const opened = await studio.open({ query: "?test=1", daemon, ...options });
  const scene = { tracks: options.tracks ?? voices(count), potentials: noise(count) };
  daemon.hops(250, scene.tracks, scene.potentials);
  daemon.feed(scene);
  return { ...opened, daemon, scene };
}

const sphere = (page) => page.evaluate(() => globalThis.odasTest.probes.sphere());

/** The sphere, once it has drawn `balls` voices. */
async function drawn(page, balls) {
  await page.waitForFunction((count) => {
    const now = globalThis.odasTest.probes.sphere();
    return now.kind !== "loading" && now.balls.length === count;
  }, balls);
  return sphere(page);
}

test("0, 1, 5 and 16 voices: as many cards and balls, in less than a dozen draw calls", async () => {
  const { page, scene, done } = await open(0);
  await page.getByText("Nobody speaks").waitFor();
  for (const count of [1, 5, 16]) {
    scene.tracks = voices(count);
    await page.waitForFunction((n) => document.querySelectorAll("[data-voice]").length === n, count);
    const now = await drawn(page, count);
    assert.ok(now.calls <= 10, `${now.calls} calls`);
    assert.equal(now.mics, 4);
  }
  await done();
});

test("a voice keeps its colour while others come and go", async () => {
  const { page, scene, done } = await open(1);
  const color = () => page.locator('[data-voice="11"]').evaluate((card) => card.style.getPropertyValue("--track"));
  await page.waitForSelector('[data-voice="11"]');
  const mine = await color();
  for (const id of [50, 51, 52]) {
    scene.tracks = (t) => [...voices(1)(t), track(1, id, [60, 10])];
    await page.waitForSelector(`[data-voice="${id}"]`);
    assert.equal(await color(), mine);
    assert.notEqual(await page.locator(`[data-voice="${id}"]`).evaluate((card) => card.style.getPropertyValue("--track")), mine);
  }
  await done();
});

test("a ball has the colour of its voice, where its direction is", async () => {
  const { page, done } = await open(1, { tracks: () => [track(0, 11, [20, 5])], colorScheme: "dark" });
  await page.waitForSelector('[data-voice="11"]');
  await drawn(page, 1);
  const box = await page.locator(".sphere-box").boundingBox();
  await page.keyboard.press("1");
  // What is straight ahead is in the middle once the view from the front has been drawn.
  await page.waitForFunction((middle) => Math.abs(globalThis.odasTest.probes.sphere().centre.x - middle) < 2, box.width / 2);
  const ball = (await drawn(page, 1)).balls[0];
  const color = await page.locator('[data-voice="11"]').evaluate((card) => card.style.getPropertyValue("--track"));
  const found = await pixelsOf(page, ".sphere-box", color);
  assert.ok(found.count > 100, `${found.count} pixels of ${color}`);
  assert.ok(Math.hypot(found.x - ball.x, found.y - ball.y) < 12, JSON.stringify({ found, ball }));
  await done();
});

test("keys 1 to 4 choose the point of view", async () => {
  const { page, done } = await open(1);
  await drawn(page, 1);
  const places = [JSON.stringify((await sphere(page)).centre)];
  for (const [key, name] of [["1", "Front"], ["2", "Top"], ["3", "Side"], ["4", "Oblique"]]) {
    await page.keyboard.press(key);
    assert.equal(await page.getByRole("button", { name, exact: true }).getAttribute("aria-pressed"), "true");
    // Drawing may rest for a while on a machine that is slow.
    await page.waitForFunction((before) => !before || JSON.stringify(globalThis.odasTest.probes.sphere().centre) !== before, places.at(-1));
    places.push(JSON.stringify((await sphere(page)).centre));
  }
  assert.equal(new Set(places.slice(1)).size, 4, places.join("\n"));
  await done();
});

test("hide and solo take voices out of the picture, by button and by key", async () => {
  const { page, done } = await open(3);
  await drawn(page, 3);
  await page.locator('[data-voice="12"]').getByRole("button", { name: "Hide" }).click();
  assert.deepEqual((await drawn(page, 2)).balls.map((ball) => ball.id), [11, 13]);
  await page.keyboard.press("h");
  await drawn(page, 3);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("s");
  assert.deepEqual((await drawn(page, 1)).balls.map((ball) => ball.id), [13]);
  await page.keyboard.press("s");
  await drawn(page, 3);
  await done();
});

test("filters: both ends of the energy at one value, activity, region, voices off", async () => {
  const { page, done } = await open(3);
  await drawn(page, 3);
  const set = (name, nth, value) => page.locator(".filters").getByLabel(name).nth(nth).fill(String(value));
  await set("Energy from", 0, 0.5);
  await set("to", 0, 0.5);
  await page.waitForFunction(() => location.hash.includes("energy=0.5%7E0.5"));
  await page.getByRole("button", { name: "Reset" }).click();
  await set("Activity from", 0, 1);
  await drawn(page, 0);
  await page.getByRole("button", { name: "Reset" }).click();
  await drawn(page, 3);
  await set("Azimuth from", 0, 90);
  await set("to", 1, 91);
  await page.waitForFunction(() => globalThis.odasTest.probes.sphere().balls.length < 3);
  await page.getByRole("button", { name: "Reset" }).click();
  await page.locator(".filters").getByLabel("Voices").uncheck();
  await drawn(page, 0);
  await done();
});

test("the view can be held, scrolled back, and let go; hops go on being kept", async () => {
  const { page, daemon, scene, done } = await open(1);
  await page.waitForSelector('[data-voice="11"]');
  await page.keyboard.press(" ");
  await page.locator(".pill").waitFor();
  scene.tracks = voices(3);
  await page.waitForTimeout(400);
  assert.equal(await page.locator("[data-voice]").count(), 1, "the moment that is held shows who was there");
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => /time=/.test(location.hash));
  assert.ok(daemon.t > 250);
  await page.keyboard.press("End");
  await page.waitForFunction(() => document.querySelectorAll("[data-voice]").length === 3);
  assert.equal(await page.locator(".pill").count(), 0);
  await done();
});

test("the pointer in a chart reads out every voice of that moment and lights up its card", async () => {
  const { page, done } = await open(2);
  await drawn(page, 2);
  await page.keyboard.press(" ");
  const box = await page.locator('[data-chart="az"]').boundingBox();
  await page.mouse.move(box.x + box.width - 45, box.y + box.height / 2);
  await page.locator(".readout").getByText("#12").waitFor();
  await page.hover('[data-voice="11"]');
  await page.waitForSelector('[data-voice="11"].pointed');
  await done();
});

test("record begins in the middle of a track with the look-back, and the same key ends it", async () => {
  const { page, daemon, done } = await open(2);
  await page.waitForSelector('[data-voice="12"]');
  daemon.methods["record.start"] = () => ({ id: 5, name: "x.wav" });
  await page.locator('[data-voice="12"]').getByRole("button", { name: "Record" }).click();
  await page.getByText("Recording voice 12").waitFor();
  assert.deepEqual(daemon.calls("record.start")[0].params, { what: "track", track: 12, stream: "separated", preroll: 0.304 });
  daemon.send({ type: "recordings", active: [{ id: 5, what: "track", track: 12, name: "x.wav", seconds: 1 }], disk_free: 1e9 });
  await page.locator('[data-voice="12"]').getByRole("button", { name: "Stop recording" }).waitFor();
  await page.keyboard.press("r");
  assert.deepEqual(await daemon.called("record.stop"), { id: 5 });
  await done();
});

// Whoever presses a button lets go of it a moment later: until then it must not move away from under the pointer.
test("a button of a voice is pressed also where the voice was not chosen before", async () => {
  const { page, daemon, done } = await open(3);
  await page.waitForSelector('[data-voice="13"]');
  daemon.send(beams([[11, 14.2, 5.8, 21.4], [12, 9, 6, 20], [13, 12, 6, 19]]));
  await page.locator('[data-voice="13"]').getByText("SNR 12 dB").waitFor();
  daemon.methods["record.start"] = ({ track }) => ({ id: track, name: "x.wav" });
  for (const id of [12, 13, 11]) {
    const box = await page.locator(`[data-voice="${id}"]`).getByRole("button", { name: "Record" }).boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.waitForTimeout(200);
    await page.mouse.up();
    await page.getByText(`Recording voice ${id}`).waitFor({ timeout: 5000 });
    await page.waitForSelector(`[data-voice="${id}"].selected`);
  }
  assert.deepEqual(daemon.calls("record.start").map(({ params }) => params.track), [12, 13, 11]);
  await done();
});

test("a refused command says why", async () => {
  const { page, daemon, done } = await open(1);
  daemon.methods["record.start"] = () => {
    throw Object.assign(new Error("The disk is full: 0 bytes are left."), { code: "failed" });
  };
  await page.locator('[data-voice="11"]').getByRole("button", { name: "Record" }).click();
  await page.getByText("The disk is full").waitFor();
  await done();
});

test("a viewer is offered nothing that changes anything", async () => {
  const daemon = new FakeDaemon();
  daemon.greeting = [hello({ role: "viewer" }), kEngine];
  const { page, done } = await open(1, { daemon });
  await page.waitForSelector('[data-voice="11"]');
  assert.equal(await page.getByRole("button", { name: "Record" }).count(), 0);
  assert.equal(await page.getByLabel("Engine").count(), 0);
  await page.keyboard.press("r");
  assert.equal(daemon.calls("record.start").length, 0);
  await page.locator('[data-voice="11"]').getByRole("button", { name: "Listen" }).waitFor();
  await done();
});

test("a click on the sphere pins a beam or mutes a direction; the list takes it out again", async () => {
  const { page, daemon, done } = await open(0);
  await drawn(page, 0);
  const targets = [];
  daemon.methods["targets.set"] = ({ add = [], remove = [] }) => {
    targets.push(...add);
    return { targets: targets.filter((one) => !remove.includes(one.tag)) };
  };
  await page.keyboard.press("2");
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  const box = await page.locator(".sphere-box").boundingBox();
  await page.mouse.click(box.x + box.width / 2 + 40, box.y + box.height / 2 - 40);
  await page.getByRole("button", { name: "Mute this direction" }).click();
  const params = await daemon.called("targets.set");
  assert.equal(params.add[0].mute, true);
  assert.ok(Math.abs(Math.hypot(...params.add[0].direction) - 1) < 1e-6);
  await page.locator(".fold summary").click();
  await page.getByRole("button", { name: "Remove mute1" }).click();
  await page.getByText("None. Click the sphere").waitFor();
  await done();
});

test("the power map is asked for only while it is shown", async () => {
  const daemon = new FakeDaemon();
  daemon.greeting = [hello({ run: run({ power_grid: [[0, 0, 1], [1, 0, 0], [0, 1, 0]] }) }), kEngine];
  const { page, done } = await open(0, { daemon });
  await drawn(page, 0);
  assert.equal(daemon.subscription.topics.power, undefined);
  await page.getByRole("button", { name: "Power map" }).click();
  await page.waitForFunction(() => location.hash.includes("heat=1"));
  assert.equal(daemon.subscription.topics.power, 5);
  daemon.send(power(300, [10, 255, 90]));
  await page.getByRole("button", { name: "Power map" }).click();
  await page.waitForFunction(() => !location.hash.includes("heat=1"));
  assert.equal(daemon.subscription.topics.power, undefined);
  await done();
});

test("microphones: clipped, dead and doubled ones are said so, with what to do", async () => {
  const { page, daemon, done } = await open(0);
  daemon.send(meters([[-38, -20, 0], [-1, 0, 1], [null, null, 2], [-38, -20, 4, 1]]));
  for (const words of ["clipped", "dead", "same as 1", "Lower the gain", "Check the cable", "check the mapping"]) await page.locator(".meters").getByText(words).first().waitFor();
  await page.getByRole("button", { name: "Microphone 3", exact: true }).click();
  await page.waitForSelector('[data-mic="3"].selected');
  await done();
});

test("a link brings the view back: filters, span, point of view", async () => {
  const daemon = new FakeDaemon();
  const { page, done } = await open(2, { daemon, route: "live?potentials=0&span=60&view=top&energy=0.2~0.8" });
  assert.equal(await page.locator(".filters").getByLabel("Potentials").isChecked(), false);
  assert.equal(await page.getByLabel("Time shown").inputValue(), "60");
  assert.equal(await page.getByRole("button", { name: "Top", exact: true }).getAttribute("aria-pressed"), "true");
  await done();
});

test("a kiosk shows what is heard and no bars", async () => {
  const { page, done } = await open(1, { query: "?test=1&kiosk" });
  await page.waitForSelector('[data-voice="11"]');
  assert.equal(await page.locator(".topbar").count(), 0);
  await done();
});

test("what separation says of a voice stands on its card, all of it where the voice is chosen", async () => {
  const { page, daemon, done } = await open(2);
  await page.waitForSelector('[data-voice="12"]');
  assert.equal(daemon.subscription.topics.beams, 2);
  const card = (id) => page.locator(`[data-voice="${id}"]`);
  daemon.send(beams([[11, 14.2, 5.8, 21.4], [12, null, 6, null]]));
  await card(11).getByText("SNR 14 dB").waitFor();
  assert.equal(await card(11).getByText("Noise gain").count(), 0);
  assert.equal(await card(12).getByText("SNR").count(), 0);
  await card(11).locator(".card-head").click();
  await card(11).getByText("Noise gain 5.8 dB").waitFor();
  await card(11).getByText("Condition 21.4 dB").waitFor();
  await card(12).locator(".card-head").click();
  await card(12).getByText("Noise gain 6.0 dB").waitFor();
  assert.equal(await card(12).getByText("Condition").count(), 0);
  daemon.send(beams([]));
  await page.waitForFunction(() => !document.body.textContent.includes("Noise gain"));
  await done();
});

test("what was said stands below its voice", async () => {
  const { page, daemon, done } = await open(1);
  await page.waitForSelector('[data-voice="11"]');
  daemon.send({ type: "transcript", track: 11, text: "turn on <b>the light</b>", final: true });
  await page.locator('[data-voice="11"]').getByText("turn on <b>the light</b>").waitFor();
  await done();
});
