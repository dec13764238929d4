// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { kFilters, readFilters, writeFilters, type Filters } from "../../src/live/filters";
import { rampIndex } from "../../src/live/ramp";

test("a link says the filters, and only those that differ from the usual", () => {
  const filters: Filters = { tracks: false, potentials: true, energy: [0.25, 0.75], activity: 0.4, region: [150, -150] };
  const query = new URLSearchParams();
  writeFilters(filters, query);
  assert.deepEqual(readFilters(query), filters);
  const usual = new URLSearchParams();
  writeFilters(kFilters, usual);
  assert.equal(usual.toString(), "");
});

test("a link made by anyone stays within bounds", () => {
  const filters = readFilters(new URLSearchParams("energy=9~-4&activity=NaN&region=1e9~x&tracks=yes"));
  assert.deepEqual(filters, { ...kFilters, energy: [0, 1], region: [180, 180] });
});

test("both ends of the energy at one value: every colour is a colour", () => {
  for (const energy of [0, 0.5, 1, NaN]) {
    const index = rampIndex(energy, [0.5, 0.5]);
    assert.ok(Number.isInteger(index) && index >= 0 && index <= 255, `${energy}: ${index}`);
  }
});
