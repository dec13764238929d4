// SPDX-License-Identifier: MIT
// A reporter of node's: how long the tests of each file took, the longest first.
import { basename } from "node:path";

export default async function* times(events) {
  const seconds = new Map();
  for await (const { type, data } of events) {
    if ((type !== "test:pass" && type !== "test:fail") || data.nesting > 0 || !data.file) continue;
    const name = basename(data.file);
    seconds.set(name, (seconds.get(name) ?? 0) + (data.details?.duration_ms ?? 0) / 1000);
  }
  const longest = [...seconds].sort((a, b) => b[1] - a[1]).filter(([, time]) => time >= 1);
  for (const [name, time] of longest) yield `# ${time.toFixed(0).padStart(4)} s  ${name}\n`;
}
