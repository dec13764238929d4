// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { axeFaults, useStudio } from "../support/browser.mjs";
import { FakeDaemon } from "../support/daemon.mjs";
import { health, hello, meters, run } from "../support/fixtures.mjs";
import { noise, voices } from "../support/voices.mjs";

const studio = useStudio();
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

async function open(options = {}) {
  const daemon = new FakeDaemon();
  daemon.greeting[0] = hello({ run: run({ slots: 16, targets: [{ tag: "door", direction: [0, 1, 0], mute: false }] }) });
  const opened = await studio.open({ query: "?test=1", daemon, ...options });
  daemon.feed({ tracks: voices(5), potentials: noise(5) });
  daemon.send(health());
  daemon.send(meters([[-38, -20, 0], [-1, 0, 1], [null, null, 2], [-38, -20, 4, 1]]));
  daemon.send({ type: "log", lines: [{ at: "2026-01-31T12:00:00Z", level: "warning", text: "Microphone 3 is silent" }, { level: "error", text: "x" }] });
  daemon.send({ type: "transcript", track: 12, text: "turn on the light", final: false });
  await opened.page.waitForSelector('[data-voice="11"]');
  return { ...opened, daemon };
}

for (const theme of ["light", "dark", "contrast"]) {
  test(`axe finds nothing on the live page, ${theme}`, async () => {
    const { page, done } = await open({ prepare: (page) => page.addInitScript((name) => localStorage.setItem("odas.theme", JSON.stringify(name)), theme) });
    await page.locator(".fold summary").click();
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), theme);
    assert.deepEqual(await axeFaults(page, axe), []);
    await page.keyboard.press("?");
    assert.deepEqual(await axeFaults(page, axe), []);
    await done();
  });
}

test("the theme follows the system, and a key chooses another", async () => {
  const { page, done } = await open({ colorScheme: "dark" });
  const becomes = (name) => page.waitForFunction((theme) => document.documentElement.dataset.theme === theme, name);
  await becomes("dark");
  await page.emulateMedia({ colorScheme: "light" });
  await becomes("light");
  await page.emulateMedia({ contrast: "more" });
  await becomes("contrast");
  await page.emulateMedia({ contrast: "no-preference" });
  await page.keyboard.press("t");
  await page.keyboard.press("t");
  await becomes("dark");
  await page.reload();
  await becomes("dark");
  await done();
});

test("320 pixels wide, and twice as large letters: nothing runs off the side", async () => {
  const { page, done } = await open({ viewport: { width: 320, height: 640 } });
  const wide = () => page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok((await wide()) <= 320, `${await wide()}`);
  await page.setViewportSize({ width: 640, height: 480 });
  await page.addStyleTag({ content: "html { font-size: 200% }" });
  assert.ok((await wide()) <= 640, `${await wide()}`);
  await done();
});

test("forced colours leave every control its name and its state", async () => {
  const { page, done } = await open({ forcedColors: "active" });
  await page.getByRole("button", { name: "Oblique", pressed: true }).waitFor();
  await done();
});

test("the whole journey goes by keyboard: skip, choose, solo, help and back", async () => {
  const { page, done } = await open();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.id), "main");
  await page.keyboard.press("ArrowDown");
  await page.waitForSelector('[data-voice="11"].selected');
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.closest("[data-voice]")?.dataset.voice ?? document.activeElement.textContent), "11");
  await page.keyboard.press("?");
  const dialog = page.getByRole("dialog", { name: "Keyboard and help" });
  await dialog.getByText("Hold the view, or go on").waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await dialog.count(), 0);
  await page.keyboard.press("g");
  await page.waitForFunction(() => location.hash.startsWith("#/recordings"));
  await done();
});

test("the sphere is told in words, and who comes is announced unless that is off", async () => {
  const { page, daemon, done } = await open();
  await page.getByRole("img", { name: /Sphere of directions\. voice 11 at/ }).waitFor();
  assert.equal(await page.getByRole("row", { includeHidden: true }).count(), 6);
  await page.locator("[data-announcer]").getByText(/appeared/).waitFor({ state: "attached" });
  await page.locator("summary[aria-label=Settings]").click();
  await page.getByLabel("Announce voices").uncheck();
  assert.equal(await page.evaluate(() => localStorage.getItem("odas.announce")), "false");
  assert.ok(daemon.t > 0);
  await done();
});

test("French, and radians", async () => {
  const { page, done } = await open({ locale: "fr-CA" });
  await page.getByRole("heading", { name: "Directions dans le temps" }).waitFor();
  assert.equal(await page.evaluate(() => document.documentElement.lang), "fr");
  await page.locator("summary[aria-label=Réglages]").click();
  await page.getByLabel("Angles").selectOption("rad");
  await page.locator('[data-voice="11"]').getByText(/rad/).first().waitFor();
  await done();
});
