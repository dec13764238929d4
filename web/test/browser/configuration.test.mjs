// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { hello } from "../support/fixtures.mjs";
import { emptyDaemon, fullDaemon } from "../support/scenes.mjs";

const studio = useStudio();

async function openForm(daemon) {
  const opened = await studio.open({ route: "configuration?tab=form", daemon });
  await opened.page.waitForSelector(".section");
  await opened.page.locator(".section summary").nth(3).click();
  return opened;
}

test("a value that cannot be is refused at its field, and the engine is left alone", async () => {
  const { daemon, config } = fullDaemon();
  const { page, done } = await openForm(daemon);
  const field = page.locator("#field-sst-N_prob");
  await field.fill("many");
  await field.press("Enter");
  await page.getByText("A number is wanted.").waitFor();
  assert.equal(daemon.calls("config.edit").length, 0);
  await field.fill("5000");
  await field.press("Enter");
  await page.locator(".field.bad").getByText("is at most 1000 with this hop").waitFor();
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  assert.ok(await page.getByRole("button", { name: "Apply" }).isDisabled());
  assert.equal(config.applied.length, 0);
  await done();
});

test("a change is seen as difference, says what applying does, is applied and taken back", async () => {
  const { daemon, config } = fullDaemon();
  const { page, done } = await openForm(daemon);
  const field = page.locator("#field-sst-N_prob");
  await field.fill("12");
  await field.press("Enter");
  await page.getByText("the pipeline is made anew between two hops").waitFor();
  await page.getByRole("tab", { name: "Changes" }).click();
  assert.ok((await page.locator("tr.removed").first().textContent()).includes("N_prob = 8;"));
  assert.ok((await page.locator("tr.added").first().textContent()).includes("N_prob = 12;"));
  await page.getByRole("button", { name: "Apply" }).click();
  await page.getByText("This is what runs").waitFor();
  assert.equal(config.applied.length, 1);
  await page.getByText("No changes", { exact: true }).waitFor();
  await page.getByRole("button", { name: "Revert" }).click();
  await page.getByText("Reverted:").waitFor();
  await page.getByRole("tab", { name: "Form" }).click();
  await page.locator(".section summary").nth(3).click();
  assert.equal(await page.inputValue("#field-sst-N_prob"), "8");
  await done();
});

test("form and text are kept in step, and a text that cannot be read is marked at its line", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await openForm(daemon);
  await page.getByRole("tab", { name: "Text" }).click();
  const area = page.getByLabel("Configuration as text");
  const text = await area.inputValue();
  await area.fill(text.replace("N_prob = 8", "N_prob = 21"));
  await page.getByText("Not applied yet").waitFor();
  await page.getByRole("tab", { name: "Form" }).click();
  await page.locator(".section summary").nth(3).click();
  await page.waitForFunction(() => document.querySelector("#field-sst-N_prob")?.value === "21");
  await page.getByRole("tab", { name: "Text" }).click();
  await area.fill(`!!\n${text}`);
  await page.locator(".gutter .marked").waitFor();
  assert.equal(await page.locator(".gutter .marked").textContent(), "1");
  await page.getByText("line 1: syntax error").first().waitFor();
  await done();
});

test("items of lists come and go", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await openForm(daemon);
  await page.getByRole("button", { name: "Add an item to sst.target" }).click();
  await page.waitForSelector("#field-sst-target-0--tag");
  await page.fill("#field-sst-target-0--tag", "door");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector("#field-sst-target-0--tag").value === "door");
  assert.deepEqual(daemon.calls("config.edit").at(-1).params.changes, [{ path: "sst.target[0].tag", value: "door" }]);
  await page.getByRole("button", { name: "Remove item 1 of sst.target" }).click();
  await page.waitForSelector("#field-sst-target-0--tag", { state: "detached" });
  await done();
});

test("as many microphones are drawn as there are, templates too, and twins are warned of", async () => {
  const { daemon } = fullDaemon();
  const { page, done } = await studio.open({ route: "configuration", daemon });
  await page.waitForSelector('[data-mics="4"]');
  await page.getByText("64.0 mm", { exact: true }).waitFor();
  await page.getByRole("button", { name: "Place these microphones" }).click();
  await page.waitForSelector('[data-mics="6"]');
  await page.getByRole("button", { name: "Add a microphone" }).click();
  await page.waitForSelector('[data-mics="7"]');
  await page.getByLabel("Mic 7 x (m)").fill("0.045");
  await page.keyboard.press("Enter");
  await page.getByText("Microphones 1 and 7 are in the same place").waitFor();
  await page.getByRole("button", { name: "Remove microphone 7" }).click();
  await page.waitForSelector('[data-mics="6"]');
  await done();
});

test("with nothing configured, a device and an array are chosen and opened", async () => {
  const { daemon } = emptyDaemon();
  const { page, done } = await studio.open({ route: "configuration", daemon });
  await page.getByText("ReSpeaker 4 Mic Array (UAC1.0)").waitFor();
  assert.ok(await page.getByRole("button", { name: "Listen" }).isDisabled());
  await page.locator(".first-run select").selectOption("respeaker_usb_4_mic");
  await page.getByRole("button", { name: "Listen" }).click();
  await page.waitForFunction(() => location.hash.startsWith("#/live") || document.querySelector(".first-run"));
  assert.deepEqual(daemon.calls("engine.open")[0].params, {
    array: "respeaker_usb_4_mic", source: { type: "soundcard_name", devicename: "hw:CARD=ArrayUAC10,DEV=0" },
  });
  await done();
});

test("a viewer reads everything and can change nothing", async () => {
  const { daemon } = fullDaemon();
  daemon.greeting[0] = hello({ role: "viewer" });
  const { page, done } = await openForm(daemon);
  await page.getByText("You are here as a viewer").waitFor();
  assert.ok(await page.locator("#field-sst-N_prob").isDisabled());
  assert.equal(await page.getByRole("button", { name: /^(Apply|Save|Revert|Add)/ }).count(), 0);
  await done();
});

test("the configuration is changed by keyboard alone", async () => {
  const { daemon, config } = fullDaemon();
  const { page, done } = await studio.open({ route: "configuration", daemon });
  await page.waitForSelector('[data-mics="4"]');
  const reach = async (is) => {
    for (let i = 0; i < 120; ++i) {
      await page.keyboard.press("Tab");
      if (await page.evaluate(is)) return;
    }
    assert.fail(`never reached ${is}`);
  };
  await reach(() => document.activeElement.id === "tab-array");
  await page.keyboard.press("ArrowRight");
  await page.waitForSelector('#tab-form[aria-selected="true"]');
  await reach(() => document.activeElement.textContent.startsWith("sst"));
  await page.keyboard.press("Enter");
  await reach(() => document.activeElement.id === "field-sst-N_prob");
  await page.keyboard.press("Control+a");
  await page.keyboard.type("9");
  await page.keyboard.press("Enter");
  await page.getByText("Not applied yet").waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll(".config-bar .primary")].some((button) => !button.disabled));
  for (let i = 0; i < 120; ++i) {
    await page.keyboard.press("Shift+Tab");
    if (await page.evaluate(() => document.activeElement.textContent === "Apply")) break;
  }
  await page.keyboard.press("Enter");
  await page.getByText("This is what runs").waitFor();
  assert.equal(config.applied.length, 1);
  await done();
});
