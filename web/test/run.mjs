// SPDX-License-Identifier: MIT
// All tests of the page: types, units, then the browser. `node test/run.mjs [WORD...]` runs only files whose name has one of the words.
import { spawn } from "node:child_process";
import { readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

import { buildPage } from "../build.mjs";
import { launchServer } from "./support/chromium.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const out = join(root, ".test");
const words = process.argv.slice(2);
const wanted = (name) => words.length === 0 || words.some((word) => name.includes(word));

function run(command, args, env = {}) {
  return new Promise((resolve) => {
    spawn(command, args, { cwd: root, stdio: "inherit", env: { ...process.env, ...env } }).on("close", (code) => resolve(code ?? 1));
  });
}

rmSync(out, { recursive: true, force: true });
await buildPage(join(out, "dist"));
const units = readdirSync(join(root, "test/unit")).filter((name) => name.endsWith(".test.ts") && wanted(name));
await build({
  absWorkingDir: root,
  entryPoints: units.map((name) => `test/unit/${name}`),
  outdir: join(out, "unit"),
  bundle: true,
  platform: "node",
  format: "esm",
  jsx: "automatic",
  jsxImportSource: "preact",
  outExtension: { ".js": ".mjs" },
  loader: { ".css": "empty" },
  logLevel: "warning",
});

const types = words.length === 0 ? await run(join(root, "node_modules/.bin/tsc"), ["--noEmit"]) : 0;
const browser = readdirSync(join(root, "test/browser")).filter((name) => name.endsWith(".test.mjs") && wanted(name));
// Against the real daemon, where there is one: ODAS_PROGRAM, or ../build/bin/odas.
const daemon = readdirSync(join(root, "test/e2e")).filter((name) => name.endsWith(".test.mjs") && wanted(name));
const files = [
  ...units.map((name) => join(out, "unit", name.replace(/\.ts$/, ".mjs"))),
  ...browser.map((name) => join(root, "test/browser", name)),
  ...daemon.map((name) => join(root, "test/e2e", name)),
];

const times = join(root, "test/support/times.mjs");
const reporters = ["tap", times].flatMap((name) => [`--test-reporter=${name}`, "--test-reporter-destination=stdout"]);

const server = await launchServer();
const runTests = (some, concurrency) =>
  some.length === 0 ? 0 : run(process.execPath, ["--test", ...reporters, `--test-concurrency=${concurrency}`, ...some], { ODAS_BROWSER: server.wsEndpoint(), ODAS_DIST: join(out, "dist") });
// Sound is played in real time: those tests have the machine to themselves.
const isHeard = (file) => /(listen|sound)\.test/.test(file);
const tests = await runTests(files.filter((file) => !isHeard(file)), 2);
const heard = await runTests(files.filter(isHeard), 1);
await server.close();
process.exit(types || tests || heard);
