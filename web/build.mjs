// SPDX-License-Identifier: MIT
// Builds web/dist: the page, its style, and chunks that are loaded when they are needed. The same input gives the same bytes.
import { build } from "esbuild";
import { cpSync, mkdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

import { kBudget, weigh } from "./test/support/weight.mjs";

const root = dirname(fileURLToPath(import.meta.url));

export async function buildPage(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  await build({
    absWorkingDir: root,
    entryPoints: { app: "src/main.tsx", "listen-worklet": "src/audio/worklet.ts" },
    outdir: folder,
    bundle: true,
    splitting: true,
    format: "esm",
    target: ["es2022"],
    minify: true,
    legalComments: "linked",
    charset: "utf8",
    jsx: "automatic",
    jsxImportSource: "preact",
    chunkNames: "chunk-[name]-[hash]",
    logLevel: "warning",
  });
  cpSync(join(root, "src/static"), folder, { recursive: true });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const folder = join(root, "dist");
  await buildPage(folder);
  const files = weigh(folder);
  const total = files.reduce((sum, file) => sum + file.bytes, 0);
  for (const { name, bytes } of files) console.log(`${(bytes / 1024).toFixed(1).padStart(8)} kB  ${name}`);
  console.log(`${(total / 1024).toFixed(1).padStart(8)} kB  gzipped, of ${kBudget / 1024} kB`);
  if (total > kBudget) {
    console.error("The page is heavier than its budget: load less, or later.");
    process.exit(1);
  }
}
