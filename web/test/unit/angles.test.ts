// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { inRegion, wrap } from "../../src/store/angles";

test("a region may lie over the back", () => {
  assert.ok(inRegion(175, 150, -150));
  assert.ok(inRegion(-175, 150, -150));
  assert.ok(!inRegion(0, 150, -150));
  assert.ok(inRegion(0, 30, 30), "equal ends leave everything");
});

test("angles are wrapped to half a turn", () => {
  assert.equal(wrap(190), -170);
  assert.equal(wrap(-181), 179);
});
