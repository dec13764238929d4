// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { hello } from "../support/fixtures.mjs";
import { emptyDaemon, fullDaemon, serveFiles } from "../support/scenes.mjs";

const studio = useStudio();
const open = (options) => studio.open({ route: "recordings", prepare: serveFiles, ...options });
const names = (page) => page.$$eval(".recording", (rows) => rows.map((row) => row.dataset.name));

test("recordings stand with the newest first, and filters leave what is wanted", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await open({ daemon });
  await page.waitForSelector(".recording");
  assert.equal((await names(page))[0], "20260131T120412.250Z_source_14.wav");
  await page.fill('input[type="search"]', "red cup");
  assert.deepEqual(await names(page), ["20260131T120412.250Z_source_14.wav"]);
  await page.fill('input[type="search"]', "nobody said this");
  await page.getByText("No recording matches").waitFor();
  await page.getByRole("button", { name: "Show all" }).click();
  await page.locator(".list-filters select").first().selectOption("raw");
  assert.deepEqual(await names(page), ["20260131T120000.125Z_raw.wav"]);
  await done();
});

test("a recording plays in the page, from where one goes", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await open({ daemon });
  const row = page.locator(".recording").first();
  await row.getByRole("button", { name: /^Play/ }).click();
  await row.getByRole("button", { name: /^Pause/ }).waitFor();
  const slider = row.getByRole("slider");
  await slider.focus();
  await page.keyboard.press("PageUp");
  await page.waitForFunction(() => Number(document.querySelector('.recording [role="slider"]').getAttribute("aria-valuenow")) > 0);
  await done();
});

test("files are deleted by the names that were confirmed, and only after the time to think again", async () => {
  const { daemon, records } = fullDaemon();
  const { page, done } = await open({ daemon });
  const row = page.locator('[data-name="20260131T120309.000Z_source_13.wav"]');
  await row.getByRole("button", { name: /^Delete/ }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Cancel" }).click();
  assert.equal((await names(page)).length, 4);
  await row.getByRole("button", { name: /^Delete/ }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Delete" }).click();
  await row.waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Undo" }).click();
  await row.waitFor();
  assert.equal(daemon.calls("recordings.delete").length, 0, "it was taken back");
  await row.getByRole("button", { name: /^Delete/ }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Delete" }).click();
  await page.click('nav a[href="#/live"]');
  await page.waitForFunction(() => location.hash.startsWith("#/live"));
  await page.click('nav a[href="#/recordings"]');
  await page.waitForSelector(".recording");
  assert.deepEqual(daemon.calls("recordings.delete").map(({ params }) => params.names), [["20260131T120309.000Z_source_13.wav"]]);
  assert.equal(records.list.length, 3);
  await done();
});

test("a label is given, and chosen recordings go into one ZIP", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await open({ daemon });
  const row = page.locator(".recording").first();
  await row.getByRole("button", { name: /^Rename/ }).click();
  await row.locator("input:focus").waitFor();
  await page.keyboard.type("The red cup");
  await page.keyboard.press("Enter");
  await page.getByText("The red cup", { exact: true }).waitFor();
  assert.deepEqual(daemon.calls("recordings.rename")[0].params, { name: "20260131T120412.250Z_source_14.wav", label: "The red cup" });
  await row.getByRole("checkbox").check();
  const link = await page.getByRole("link", { name: "Download chosen (ZIP)" }).getAttribute("href");
  assert.equal(link, "/api/v1/recordings.zip?name=20260131T120412.250Z_source_14.wav");
  await done();
});

test("what is being recorded stands there with a button that stops it", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await open({ daemon });
  await page.getByRole("button", { name: "Record the microphones" }).last().click();
  await page.waitForFunction(() => true);
  daemon.send({ type: "recordings", active: [{ id: 3, what: "track", track: 15, name: "x.wav", seconds: 2.4 }], disk_free: 4e8 });
  await page.getByText("Only 400").waitFor();
  await page.getByRole("button", { name: "Stop: Voice 15" }).click();
  await page.getByText("Saved:").waitFor();
  assert.deepEqual(daemon.calls("record.start")[0].params, { what: "raw" });
  assert.deepEqual(daemon.calls("record.stop")[0].params, { id: 3 });
  await done();
});

test("an empty list says the next step; a viewer is told that he may not change anything", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await open({ daemon });
  await page.getByText("No recordings yet").waitFor();
  await done();
  const viewer = fullDaemon();
  viewer.daemon.greeting[0] = hello({ role: "viewer" });
  const second = await open({ daemon: viewer.daemon });
  await second.page.waitForSelector(".recording");
  await second.page.getByText("You are here as a viewer").waitFor();
  assert.equal(await second.page.getByRole("button", { name: /^(Delete|Rename)/ }).count(), 0);
  await second.done();
});

test("the whole way through the recordings is gone by keyboard alone", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await open({ daemon });
  await page.waitForSelector(".recording");
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.textContent ?? "");
  const reach = async (wanted) => {
    for (let i = 0; i < 80; ++i) {
      await page.keyboard.press("Tab");
      if ((await focused()).startsWith(wanted)) return;
    }
    assert.fail(`never reached ${wanted}`);
  };
  await reach("Play");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: /^Pause/ }).waitFor();
  await reach("Position in");
  await page.keyboard.press("End");
  await reach("Delete");
  await page.keyboard.press("Enter");
  await page.getByRole("dialog").waitFor();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  assert.ok((await focused()).startsWith("Delete"), "the focus is back where it was");
  await done();
});
