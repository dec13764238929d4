// SPDX-License-Identifier: MIT
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

/** What a first visit and all later chunks may weigh together, gzipped. */
export const kBudget = 250 * 1024;

/** Bytes of each file below `folder`, as they travel (gzipped). */
export function weigh(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => {
      const path = join(entry.parentPath ?? entry.path, entry.name);
      return { name: path.slice(folder.length + 1), bytes: gzipSync(readFileSync(path), { level: 9 }).length };
    })
    .sort((a, b) => a.name.localeCompare(b.name));
}
