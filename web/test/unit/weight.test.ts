// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { kBudget, weigh } from "../support/weight.mjs";

const folder = process.env.ODAS_DIST!;

test("the page weighs no more than its budget, and 3-D is loaded later", () => {
  const files = weigh(folder);
  const total = files.reduce((sum, file) => sum + file.bytes, 0);
  assert.ok(total <= kBudget, `${total}`);
  const app = readFileSync(join(folder, "app.js"), "utf8");
  assert.ok(!/from"\.\/chunk-scene/.test(app) && !/WebGLRenderer/.test(app), "the scene is not part of what is loaded first");
});
