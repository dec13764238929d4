// SPDX-License-Identifier: MIT
// One browser for all tests of a file; every fault of a page (exception, console error, refused policy, foreign request) fails its test.
import assert from "node:assert/strict";
import { after, afterEach, before } from "node:test";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { connect, launch } from "./chromium.mjs";
import { FakeDaemon } from "./daemon.mjs";
import { serve } from "./server.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

export const kDist = process.env.ODAS_DIST ?? join(root, "dist");

/**
 * For a test file: `const studio = useStudio();`, then in each test `const { page, daemon, done } = await studio.open()`, at its end
 * `await done()`. `open` takes `route`, `query` (before the hash), `daemon`, `host` and the options of a browser context.
 */
export function useStudio({ flags } = {}) {
  let browser;
  const servers = new Map();
  const opened = [];
  // A test that failed has not ended its page.
  afterEach(async () => {
    for (const { context, daemon } of opened.splice(0)) {
      daemon.stop();
      await context.close().catch(() => {});
    }
  });
  before(async () => {
    const shared = process.env.ODAS_BROWSER;
    browser = shared && !flags ? await connect(shared) : await launch(flags);
  });
  after(async () => {
    await browser?.close();
    for (const server of servers.values()) server.close();
  });

  async function origin(host) {
    if (!servers.has(host)) servers.set(host, await serve(kDist, host));
    return `http://${host}:${servers.get(host).address().port}`;
  }

  async function open({ route = "live", query = "", daemon = new FakeDaemon(), host = "127.0.0.1", url, prepare, ...options } = {}) {
    const base = url ?? (await origin(host));
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
    opened.push({ context, daemon });
    await context.addInitScript(() => addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) => console.error(`policy ${violatedDirective}: ${blockedURI}`)));
    const page = await context.newPage();
    // Long, since whoever runs the tests may have other work for the computer.
    page.setDefaultTimeout(60000);
    const faults = watch(page, new URL(base).origin);
    if (!url) await daemon.attach(page);
    await prepare?.(page);
    await page.goto(`${base}/${query}#/${route}`);
    await page.waitForSelector("main");
    return {
      page,
      daemon,
      faults,
      origin: base,
      /** Ends the test's page; `expected` are words of faults that the test provoked. */
      async done(expected = []) {
        const rest = faults.filter((fault) => !expected.some((words) => fault.includes(words)));
        daemon.stop();
        await context.close();
        assert.deepEqual(rest, []);
      },
    };
  }

  return { open };
}

function watch(page, origin) {
  const faults = [];
  page.on("pageerror", (error) => faults.push(`exception: ${error.stack ?? error}`));
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(`console: ${message.text()}`);
  });
  page.on("request", (request) => {
    const url = new URL(request.url());
    if (/^https?:$/.test(url.protocol) && url.origin !== origin) faults.push(`foreign request: ${url}`);
  });
  page.on("websocket", (socket) => {
    if (new URL(socket.url()).host !== new URL(origin).host) faults.push(`foreign socket: ${socket.url()}`);
  });
  return faults;
}

/**
 * Pixels of a screenshot of `selector` that are within `tolerance` of `color` ("#rrggbb"): how many, and their middle in CSS pixels
 * of the element.
 */
export async function pixelsOf(page, selector, color, tolerance = 6) {
  const shot = await page.locator(selector).first().screenshot();
  return page.evaluate(async ({ data, color, tolerance }) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const draw = canvas.getContext("2d");
    draw.drawImage(image, 0, 0);
    const pixels = draw.getImageData(0, 0, image.width, image.height).data;
    const want = [1, 3, 5].map((k) => parseInt(color.slice(k, k + 2), 16));
    let count = 0;
    let x = 0;
    let y = 0;
    for (let k = 0; k < pixels.length; k += 4) {
      if (want.some((value, c) => Math.abs(pixels[k + c] - value) > tolerance)) continue;
      count++;
      x += (k / 4) % image.width;
      y += Math.floor(k / 4 / image.width);
    }
    return { count, x: x / count / devicePixelRatio, y: y / count / devicePixelRatio };
  }, { data: shot.toString("base64"), color, tolerance });
}

/** The faults that axe finds, in one line each. */
export async function axeFaults(page, source) {
  await page.evaluate(source);
  return page.evaluate(async () => {
    const result = await globalThis.axe.run(document, { resultTypes: ["violations"] });
    return result.violations.map((one) => `${one.id}: ${one.nodes.map((node) => `${node.target} ${node.any.map((why) => why.message).join("; ")}`).join(" | ")}`);
  });
}
