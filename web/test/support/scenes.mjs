// SPDX-License-Identifier: MIT
// Daemons with something to show, for tests and pictures of the pages.
import { FakeDaemon } from "./daemon.mjs";
import { fakeConfig } from "./config.mjs";
import { health, hello, kEngine, meters } from "./fixtures.mjs";
import { fakeRecords, wav } from "./recordings.mjs";
import { sessionFile } from "./mcap.mjs";

export const kLog = {
  type: "log",
  lines: [
    { at: "2026-01-31T12:00:00.125Z", level: "info", text: "respeaker_usb_4_mic: 4 microphones, 16000 Hz, hop 128" },
    { at: "2026-01-31T12:00:00.400Z", level: "info", text: "hw:CARD=ArrayUAC10,DEV=0 opened: 6 channels, 16 bit" },
    { at: "2026-01-31T12:03:10.020Z", level: "warning", text: "microphone 3 is silent: is its cable in?" },
    { at: "2026-01-31T12:04:00.000Z", level: "error", text: "an overrun: 512 frames were lost" },
  ],
};

/** Everything there is: recordings, sessions, a configuration, figures. */
export function fullDaemon(helloFields = {}) {
  const daemon = new FakeDaemon();
  const config = fakeConfig();
  const records = fakeRecords();
  daemon.greeting = [hello(helloFields), kEngine, kLog, { type: "recordings", active: [], disk_free: 182e9 }, health(), meters()];
  daemon.methods = { ...config.methods, ...records.methods };
  return { daemon, config: config.state, records: records.state };
}

/** Nothing recorded, nothing configured. */
export function emptyDaemon() {
  const { daemon } = fullDaemon({ run: null });
  daemon.greeting = [hello({ run: null }), { type: "engine", state: "idle", what: "" }];
  daemon.methods["recordings.list"] = () => [];
  daemon.methods["sessions.list"] = () => [];
  return { daemon };
}

/** Answers for the files that the daemon serves. */
export async function serveFiles(page, options = {}) {
  await page.route("**/api/v1/recordings/**", (route) => route.fulfill({ body: wav(4), contentType: "audio/wav" }));
  await page.route("**/api/v1/sessions/**", (route) => route.fulfill({ body: sessionFile(options), contentType: "application/octet-stream" }));
}

/** Figures of the last minutes, one a second of the page's own time. */
export async function sendFigures(daemon, count = 40) {
  for (let i = 0; i < count; ++i) {
    const wave = Math.sin(i / 5);
    daemon.send(health({ hops: 12000 + 125 * i, hop_p50_us: 410 + 30 * wave, hop_p99_us: 890 + 120 * Math.abs(wave), cpu: 0.062 + 0.01 * wave, overruns: i > 30 ? 1 : 0, real_time_share: 0.051 + 0.01 * wave }));
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
}
