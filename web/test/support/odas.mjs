// SPDX-License-Identifier: MIT
// The real daemon, for tests from end to end.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const kTree = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const program = process.env.ODAS_PROGRAM ?? join(kTree, "build/bin/odas");

/** Why a test against the daemon cannot run here; false: it can. */
export const noDaemon = existsSync(program) ? false : `${program} is not built`;

/** Arguments that play the sample over and over. */
export const kSample = [join(kTree, "configs/sample.cfg"), "--play", join(kTree, "samples/sample_4mic.flac"), "--loop"];

/** Starts `odas studio ARGUMENTS...` at a port of its own; resolves once it says where it is. */
export function startDaemon(args = kSample, port = 0) {
  const folder = mkdtempSync(join(tmpdir(), "odas-studio-"));
  const child = spawn(program, ["studio", ...args, "--listen", `127.0.0.1:${port}`, "--recordings", folder], { cwd: folder });
  let said = "";
  const ended = new Promise((resolve) => child.on("close", (code) => resolve(code)));
  const daemon = {
    folder,
    /** What it has said so far. */
    said: () => said,
    pid: child.pid,
    signal: (name) => child.kill(name),
    ended,
    /** Ends it as Ctrl-C does; resolves with its exit code. */
    async stop() {
      child.kill("SIGINT");
      const code = await ended;
      rmSync(folder, { recursive: true, force: true });
      return code;
    },
  };
  return new Promise((resolve, reject) => {
    child.stdout.resume();
    child.stderr.on("data", (data) => {
      said += data;
      const at = /Studio: (http\S+)\/ /.exec(said);
      if (at) resolve(Object.assign(daemon, { url: at[1], port: Number(new URL(at[1]).port) }));
    });
    ended.then((code) => reject(new Error(`the daemon ended with ${code}: ${said}`)));
  });
}
