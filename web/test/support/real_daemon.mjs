// SPDX-License-Identifier: MIT
// The daemon itself, hearing the sample recording in a loop: ODAS_PROGRAM, or what is built beside the page.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const tree = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const program = process.env.ODAS_PROGRAM ?? join(tree, "build/bin/odas");

/** Why there is no daemon to test with, or false. */
export const missing = existsSync(program) ? false : `there is no ${program}: build odas, or set ODAS_PROGRAM`;

export function temporaryFolder() {
  const path = mkdtempSync(join(tmpdir(), "odas-studio-"));
  return { path, remove: () => rmSync(path, { recursive: true, force: true }) };
}

/**
 * Resolves with `{url, token, port, kill(signal)}` once the daemon serves; `kill` resolves with its exit code when it is gone. `listen`
 * is where, by default a port of the system's choice on this computer alone; `recordings` the folder of its recordings.
 */
export function startDaemon({ recordings, listen = "127.0.0.1:0", options = [] }) {
  const sample = join(tree, "samples/sample_4mic.flac");
  const child = spawn(program, [
    "studio", join(tree, "configs/sample.cfg"), "--play", sample, "--loop", "--listen", listen, "--recordings", recordings, "--no-qr", ...options,
  ]);
  const gone = new Promise((resolve) => child.on("close", resolve));
  return new Promise((resolve, reject) => {
    let said = "";
    const read = (bytes) => {
      said += bytes;
      const [, url] = /Studio: (http:\/\/\S+)\s/.exec(said) ?? [];
      if (!url) return;
      const { port, searchParams } = new URL(url);
      resolve({
        url,
        port,
        token: searchParams.get("token"),
        kill: (signal = "SIGTERM") => {
          child.kill(signal);
          return gone;
        },
      });
    };
    child.stdout.on("data", read);
    child.stderr.on("data", read);
    child.on("error", reject);
    gone.then((code) => reject(new Error(`odas ended with ${code} and said: ${said}`)));
  });
}
