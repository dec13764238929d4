// SPDX-License-Identifier: MIT
// web/dist is what the sources give, byte for byte, and no heavier than it may be.
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { buildPage } from "../build.mjs";
import { kBudget, weigh } from "./support/weight.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const kept = join(root, "dist");
const made = join(root, ".test", "bundle");
await buildPage(made);

const faults = [];
const names = new Set([...readdirSync(kept), ...readdirSync(made)]);
for (const name of names) {
  const read = (folder) => {
    try {
      return readFileSync(join(folder, name));
    } catch {
      return undefined;
    }
  };
  const [before, now] = [read(kept), read(made)];
  if (before === undefined) faults.push(`${name} is missing`);
  else if (now === undefined) faults.push(`${name} comes of nothing any more`);
  else if (!before.equals(now)) faults.push(`${name} is another one`);
}
const bytes = weigh(kept).reduce((sum, file) => sum + file.bytes, 0);
if (bytes > kBudget) faults.push(`it weighs ${bytes} bytes gzipped, over ${kBudget}`);
if (faults.length > 0) {
  console.error(`web/dist is not what its sources give (make web builds it anew):\n  ${faults.join("\n  ")}`);
  process.exit(1);
}
console.log(`bundle: ${names.size} files as the sources give them, ${(bytes / 1024).toFixed(1)} kB gzipped of ${kBudget / 1024} kB`);
