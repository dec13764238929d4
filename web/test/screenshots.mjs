// SPDX-License-Identifier: MIT
// Pictures of every route in both themes, from fixtures: `npm run screenshots [WORD...]` writes docs/images/studio/.
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { buildPage } from "../build.mjs";
import { launch } from "./support/chromium.mjs";
import { audio, direction, track } from "./support/fixtures.mjs";
import { sessionFile } from "./support/mcap.mjs";
import { emptyDaemon, fullDaemon, sendFigures, serveFiles } from "./support/scenes.mjs";
import { serve } from "./support/server.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const out = process.env.ODAS_SCREENSHOTS ?? join(root, "../docs/images/studio");
const words = process.argv.slice(2);

const two = (t) => [
  track(0, 12, [40 + 6 * Math.sin(t / 60), 12], { level: -22 - 6 * Math.abs(Math.sin(t / 13)) }),
  track(2, 13, [-120 + t / 25, -5], { level: -30, category: 2 }),
];
/** Between 0 and 1, the same at each run. */
const random = (k) => (Math.abs(Math.sin(12.9898 * k) * 43758.5453) % 1);
const peaks = (t) => [
  [...direction(40 + 8 * (random(t) - 0.5), 12 + 8 * (random(t + 0.1) - 0.5)), 0.4 + 0.5 * random(t + 0.2)],
  [...direction(-120 + t / 25 + 8 * (random(t + 0.3) - 0.5), -5 + 6 * (random(t + 0.4) - 0.5)), 0.3 + 0.4 * random(t + 0.5)],
  ...(t % 6 === 0 ? [[...direction(360 * random(t + 0.6), 80 * random(t + 0.7) - 10), 0.05 + 0.2 * random(t + 0.8)]] : []),
];

/** A harmonic voice that glides, as blocks of 512 samples. */
function speak(daemon, blocks) {
  let phase = 0;
  const tone = Array.from({ length: 512 * blocks }, (_, n) => {
    phase += (2 * Math.PI * (150 + 40 * Math.sin(n / 9000))) / 16000;
    let sum = 0;
    for (let h = 1; h < 16; ++h) sum += Math.sin(h * phase) / h;
    return 5000 * Math.max(0, Math.sin(n / 5200)) ** 0.5 * sum;
  });
  for (let block = 0; block < blocks; ++block) {
    for (const stream of [0, 2]) {
      const hiss = stream === 2 ? 40 : 2;
      const samples = Array.from({ length: 512 }, (_, i) => tone[block * 512 + i] + hiss * (2 * random(block * 512 + i) - 1));
      daemon.send(audio({ stream, source: stream === 2 ? 1 : 12, first: block * 512, samples }));
    }
  }
}

const kPicture = `<svg xmlns="http://www.w3.org/2000/svg" width="640" height="480"><defs><linearGradient id="a" x2="0" y2="1"><stop stop-color="#6d7f8c"/><stop offset="1" stop-color="#2c343b"/></linearGradient></defs><rect width="640" height="480" fill="url(#a)"/><rect y="330" width="640" height="150" fill="#4b3f35"/><circle cx="240" cy="210" r="46" fill="#c9a489"/><rect x="180" y="256" width="120" height="150" rx="40" fill="#2f5d62"/><circle cx="470" cy="240" r="38" fill="#8d6748"/><rect x="420" y="278" width="100" height="130" rx="34" fill="#7a2f3b"/></svg>`;
const camera = { url: "/camera.svg", width: 640, height: 480, fx: 550, fy: 550, cx: 320, cy: 240, position: [0, 0, 0], rotation: [0, 0, 0] };

const shots = {
  recordings: { route: "recordings", daemon: () => fullDaemon().daemon, after: async (page, daemon) => {
    daemon.send({ type: "recordings", active: [{ id: 3, what: "track", track: 15, name: "x.wav", seconds: 12.4 }], disk_free: 182e9 });
    await page.locator(".recording .play").first().click();
    await page.waitForTimeout(900);
  } },
  "recordings-empty": { route: "recordings", daemon: () => emptyDaemon().daemon },
  replay: { route: "replay", daemon: () => fullDaemon().daemon },
  "replay-empty": { route: "replay", daemon: () => emptyDaemon().daemon },
  "replay-session": { route: "replay", daemon: () => fullDaemon().daemon, after: async (page) => {
    await page.setInputFiles('input[type="file"]', { name: "kitchen.mcap", mimeType: "application/octet-stream", buffer: sessionFile({ seconds: 20, audioToo: true }) });
    await page.waitForSelector(".timeline");
    await page.focus(".timeline");
    await page.keyboard.press("PageUp");
    await page.keyboard.press("ArrowRight");
    await page.waitForTimeout(1500);
  } },
  configuration: { route: "configuration", daemon: () => fullDaemon().daemon, wait: ".facts" },
  "configuration-first": { route: "configuration", daemon: () => emptyDaemon().daemon, after: (page) => page.locator(".first-run select").selectOption("respeaker_usb_4_mic") },
  "configuration-form": { route: "configuration?tab=form", daemon: () => fullDaemon().daemon, after: async (page) => {
    await page.locator(".section summary").nth(3).click();
    await page.fill("#field-sst-N_prob", "5000");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".field.bad");
  } },
  "configuration-text": { route: "configuration?tab=text", daemon: () => fullDaemon().daemon, after: async (page) => {
    const area = page.locator("textarea");
    await area.fill((await area.inputValue()).replace("N_prob = 8", "!! N_prob = 8"));
    await page.waitForSelector(".gutter .marked");
  } },
  "configuration-changes": { route: "configuration?tab=form", daemon: () => fullDaemon().daemon, after: async (page) => {
    await page.locator(".section summary").nth(3).click();
    await page.fill("#field-sst-N_prob", "12");
    await page.keyboard.press("Enter");
    await page.waitForSelector(".config-bar .badge.warn");
    await page.click("#tab-changes");
    await page.waitForSelector(".diff");
  } },
  health: { route: "health", daemon: () => fullDaemon().daemon, after: async (page, daemon) => {
    await sendFigures(daemon);
    await page.waitForTimeout(600);
  } },
  "health-failed": { route: "health", daemon: () => {
    const { daemon } = fullDaemon();
    daemon.greeting[1] = { type: "engine", state: "failed", what: "hw:CARD=ArrayUAC10,DEV=0: no such device (exit code 1). Is the array plugged in?" };
    return daemon;
  } },
  live: { route: "live", daemon: () => fullDaemon().daemon, after: async (page, daemon) => {
    for (let i = 0; i < 24; ++i) daemon.hops(100, two, peaks);
    daemon.feed({ tracks: two, potentials: peaks });
    await page.waitForTimeout(3000);
  } },
  "live-empty": { route: "live", daemon: () => emptyDaemon().daemon },
  extras: { route: "live", daemon: () => fullDaemon({ camera }).daemon, after: async (page, daemon) => {
    const front = (t) => [track(0, 12, [8 + Math.sin(t / 60), 3]), track(2, 13, [-15, -1], { level: -30 }), track(1, 14, [170, 10])];
    for (let i = 0; i < 10; ++i) daemon.hops(100, front, peaks);
    await page.waitForSelector('[data-voice="12"]');
    await page.getByRole("button", { name: /Spectrogram/ }).click();
    await page.getByRole("button", { name: /Camera/ }).click();
    await page.keyboard.press("Tab");
    await page.locator("body").press("ArrowDown");
    await page.waitForSelector(".spectrogram canvas");
    speak(daemon, 200);
    daemon.feed({ tracks: front, potentials: peaks });
    await page.waitForSelector(".camera svg");
    await page.waitForTimeout(1200);
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await page.waitForTimeout(300);
  } },
};

mkdirSync(out, { recursive: true });
const dist = mkdtempSync(join(tmpdir(), "odas-page-"));
await buildPage(dist);
const server = await serve(dist);
const origin = `http://127.0.0.1:${server.address().port}`;
const browser = await launch();
const size = process.env.ODAS_SIZE?.split("x").map(Number) ?? [1280, 800];

async function take(name, shot, theme) {
  const context = await browser.newContext({ viewport: { width: size[0], height: size[1] }, colorScheme: theme, reducedMotion: "reduce", timezoneId: "UTC", locale: process.env.ODAS_LOCALE ?? "en-GB" });
  const daemon = shot.daemon();
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(90000);
    page.on("pageerror", (error) => console.error(name, error));
    await serveFiles(page);
    await page.route("**/camera.svg", (route) => route.fulfill({ body: kPicture, contentType: "image/svg+xml" }));
    await daemon.attach(page);
    await page.goto(`${origin}/#/${shot.route}`);
    await page.waitForSelector("main :is(h1, h2, .panel)");
    if (shot.wait) await page.waitForSelector(shot.wait);
    if (shot.route !== "live" && daemon.greeting[1].state === "running") {
      daemon.feed({ tracks: two, potentials: peaks });
      await page.waitForTimeout(3000);
    }
    await page.waitForTimeout(500);
    await shot.after?.(page, daemon);
    await page.screenshot({ path: join(out, `${name}-${theme}.png`) });
    console.log(`${name}-${theme}.png`);
  } finally {
    daemon.stop();
    await context.close();
  }
}

const themes = (process.env.ODAS_THEMES ?? "light,dark").split(",");
for (const [name, shot] of Object.entries(shots)) {
  if (words.length > 0 && !words.some((word) => name === word || name.startsWith(`${word}-`))) continue;
  for (const theme of themes) {
    await take(name, shot, theme).catch((error) => {
      console.error(`${name}-${theme}.png: ${error}`);
      process.exitCode = 1;
    });
  }
}
await browser.close();
rmSync(dist, { recursive: true });
server.close();
