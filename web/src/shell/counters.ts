// SPDX-License-Identifier: MIT
import { testing } from "./router";

/** What tests may look at, with `?test=1`: counters and probes, all read-only. */
export const counters: Record<string, number> & { paints: number } = { paints: 0 };

const probes: Record<string, () => unknown> = {};

/** Lets tests call `odasTest.NAME()`. */
export function probe(name: string, look: () => unknown): void {
  probes[name] = look;
}

if (testing) Object.assign(globalThis, { odasTest: { counters, probes } });
