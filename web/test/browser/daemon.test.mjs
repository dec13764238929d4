// SPDX-License-Identifier: MIT
// The page of the daemon itself: what a fake one cannot vouch for.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { networkInterfaces } from "node:os";
import { join } from "node:path";
import { after, afterEach, test } from "node:test";

import { useStudio } from "../support/browser.mjs";
import { missing, startDaemon, temporaryFolder } from "../support/real_daemon.mjs";

const studio = useStudio();
const folder = temporaryFolder();
const daemons = [];
const options = { skip: missing };
/** What is drawn small is drawn fast. */
const kSmall = { width: 400, height: 500 };

afterEach(() => Promise.all(daemons.splice(0).map((daemon) => daemon.kill("SIGKILL"))));
after(() => folder.remove());

async function start(more = {}) {
  const daemon = await startDaemon({ recordings: folder.path, ...more });
  daemons.push(daemon);
  return daemon;
}

const openPage = (daemon, route) => studio.open({ url: `http://127.0.0.1:${daemon.port}`, route, viewport: kSmall });
const files = (ending) => readdirSync(folder.path).filter((name) => name.endsWith(ending));

/** Resolves with status and text of a request as it is written: nothing is made tidy on the way. */
function ask(daemon, path, headers = {}) {
  return new Promise((resolve, reject) => {
    const asked = request({ host: "127.0.0.1", port: daemon.port, path, headers });
    asked.on("response", async (response) => {
      let text = "";
      for await (const piece of response) text += piece;
      resolve({ status: response.statusCode, text });
    });
    asked.on("upgrade", (response, socket) => {
      socket.destroy();
      resolve({ status: response.statusCode, text: "" });
    });
    asked.on("error", reject);
    asked.end();
  });
}

const upgrade = { Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==" };

/** Records the first voice that is there until its file has grown to `bytes`; resolves with the file's name. */
async function recordVoice(page, bytes) {
  const before = new Set(files(".wav"));
  // By key: voices of the sample come and go under a slow pointer.
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("r");
  for (;;) {
    const mine = files(".wav").find((name) => !before.has(name));
    if (mine && readFileSync(join(folder.path, mine)).length > bytes) return mine;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

test("the page of the daemon shows its voices, and says when it is gone", options, async (context) => {
  const daemon = await start();
  const ready = performance.now();
  const { page, done } = await openPage(daemon, "live");
  await page.waitForSelector("[data-voice]");
  context.diagnostic(`the first voice stood on the page ${Math.round(performance.now() - ready)} ms after the daemon was ready`);
  await page.waitForSelector('[data-state="live"]');
  await daemon.kill("SIGKILL");
  await page.waitForSelector('[data-state="offline"]');
  await page.waitForFunction(() => document.querySelectorAll("[data-voice]").length === 0);
  await done(["WebSocket", "ERR_CONNECTION_REFUSED"]);
});

test("a recording of a daemon that was killed plays", options, async () => {
  const first = await start();
  const live = await openPage(first, "live");
  await live.page.waitForSelector("[data-voice]");
  const name = await recordVoice(live.page, 32000);
  await first.kill("SIGKILL");
  await live.done(["WebSocket", "ERR_CONNECTION_REFUSED"]);

  const wav = readFileSync(join(folder.path, name));
  assert.equal(wav.toString("latin1", 0, 4), "RIFF");
  const { page, done } = await openPage(await start(), "recordings");
  const row = page.locator(`[data-name="${name}"]`);
  await row.waitFor();
  const length = await page.evaluate(async (url) => {
    const audio = new Audio(url);
    await new Promise((resolve, reject) => Object.assign(audio, { onloadedmetadata: resolve, onerror: () => reject(new Error("it does not play")) }));
    return audio.duration;
  }, `api/v1/recordings/${name}`);
  assert.ok(length > 0.5 && length < 600, `${length} s`);
  await row.getByRole("button", { name: /^Play/ }).click();
  await page.waitForSelector(`[data-name="${name}"].playing`);
  await done();
});

test("what the Studio has not made is neither listed nor deleted", options, async () => {
  for (const name of ["notes.txt", "song.wav", "song.json"]) writeFileSync(join(folder.path, name), "mine");
  const daemon = await start();
  const live = await openPage(daemon, "live");
  await live.page.waitForSelector("[data-voice]");
  await recordVoice(live.page, 8000);
  await live.page.keyboard.press("r");
  await live.done();

  const { page, done } = await openPage(daemon, "recordings");
  await page.locator(".recording").first().waitFor();
  assert.equal(await page.locator('[data-name="song.wav"]').count(), 0);
  await page.getByLabel("Choose all").check();
  await page.getByRole("button", { name: "Delete chosen" }).click();
  await page.getByRole("dialog").getByRole("button", { name: /^Delete/ }).click();
  await page.waitForFunction(() => document.querySelectorAll(".recording").length === 0);
  const left = async () => files(".wav");
  for (let tries = 0; (await left()).length > 1 && tries < 400; tries++) await page.waitForTimeout(50);
  assert.deepEqual(readdirSync(folder.path).filter((name) => /^(notes|song)/.test(name)).sort(), ["notes.txt", "song.json", "song.wav"]);
  assert.deepEqual(await left(), ["song.wav"]);
  await done();
});

test("a session replays the hops that were seen live, each once", options, async () => {
  const daemon = await start();
  const live = new Map();
  const { page, done } = await studio.open({
    url: `http://127.0.0.1:${daemon.port}`,
    viewport: kSmall,
    prepare: (page) => page.on("websocket", (socket) => socket.on("framereceived", ({ payload }) => {
      const message = typeof payload === "string" ? JSON.parse(payload) : {};
      for (const hop of message.type === "hops" ? message.hops : []) live.set(hop.t, hop);
    })),
  });
  await page.waitForSelector("[data-voice]");
  const choose = async (name) => {
    await page.locator("header summary").filter({ hasText: /^Record/ }).focus();
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name, exact: true }).focus();
    await page.keyboard.press("Enter");
  };
  await choose("Record a session");
  const begin = live.size;
  while (live.size < begin + 200) await page.waitForTimeout(50);
  await choose("Stop recording");
  await page.waitForFunction(() => document.querySelectorAll("header .recording").length === 0);

  await page.goto(`http://127.0.0.1:${daemon.port}/#/replay`);
  await page.locator(".session").first().waitFor();
  const [name] = files(".mcap");
  const theirs = await page.evaluate(async (url) => (await fetch(url)).text(), `api/v1/export/jsonl?session=${name}`);
  await page.setInputFiles('input[type="file"]', join(folder.path, name));
  const waiting = page.waitForEvent("download");
  await page.locator(".stage-head").getByRole("button", { name: "JSONL", exact: true }).focus();
  await page.keyboard.press("Enter");
  const saved = join(folder.path, "replayed.jsonl");
  await (await waiting).saveAs(saved);
  const mine = readFileSync(saved, "utf8");
  const lines = (text) => text.trim().split("\n").map((line) => JSON.parse(line));
  const replayed = lines(mine);
  const stamps = replayed.map((hop) => hop.timeStamp);
  assert.ok(replayed.length > 150, `${replayed.length} hops`);
  assert.deepEqual(stamps, stamps.map((_, k) => stamps[0] + k));
  assert.deepEqual(stamps, lines(theirs).map((hop) => hop.timeStamp));
  let compared = 0;
  for (const hop of replayed) {
    const seen = live.get(hop.timeStamp);
    if (!seen) continue;
    compared++;
    // Adding 0 makes 0 of -0, which JSON of the page does not tell apart.
    assert.deepEqual(hop.src.map(({ id, x, y, z }) => [id, x + 0, y + 0, z + 0]), (seen.tracks ?? []).map(([, id, x, y, z]) => [id, x + 0, y + 0, z + 0]));
  }
  assert.ok(compared > 100, `${compared} hops of both`);
  await done();
});

test("a foreign page, a path out of the page and a wrong host get nothing", options, async () => {
  const daemon = await start();
  const evil = { Origin: "http://evil.example" };
  assert.equal((await ask(daemon, "/")).status, 200);
  assert.equal((await ask(daemon, "/api/v1/live", upgrade)).status, 101);
  for (const path of ["/", "/api/v1/info", "/api/v1/live"]) assert.equal((await ask(daemon, path, path.endsWith("live") ? { ...upgrade, ...evil } : evil)).status, 403, path);
  assert.equal((await ask(daemon, "/", { Host: "evil.example" })).status, 403);
  writeFileSync(join(folder.path, "../odas-studio-secret.txt"), "secret");
  for (const path of ["/../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/api/v1/recordings/../odas-studio-secret.txt", "/api/v1/recordings/..%2fodas-studio-secret.txt", "/api/v1/recordings/notes.txt"]) {
    const { status, text } = await ask(daemon, path);
    assert.ok(status >= 400 && status < 500, `${path}: ${status}`);
    assert.ok(!/root:|secret\n?$/.test(text), path);
  }
});

const address = Object.values(networkInterfaces()).flat().find((one) => one.family === "IPv4" && !one.internal)?.address;

test("away from this computer there is no page without the token", { skip: missing || (address ? false : "this computer has no address but its own") }, async () => {
  const daemon = await start({ listen: `${address}:0` });
  assert.ok(daemon.token?.length >= 16, daemon.url);
  const origin = `http://${address}:${daemon.port}`;
  for (const path of ["/", "/api/v1/info", "/?token=wrong", "/api/v1/live?token=wrong"]) assert.equal((await fetch(origin + path)).status, 401, path);
  const { page, done } = await studio.open({ url: origin, query: `?token=${daemon.token}`, viewport: kSmall });
  await page.waitForSelector('[data-state="live"]');
  assert.equal(await page.evaluate(() => isSecureContext), false);
  assert.ok(!page.url().includes(daemon.token), "the token does not stay in the address");
  await done();
});
