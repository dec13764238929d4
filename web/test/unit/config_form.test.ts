// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  countChanged, faultsAt, filterFields, homelessFaults, isChanged, newItem, parseTyped, showValue, type Field,
} from "../../src/lib/config_form";

const prob: Field = { path: "sst.N_prob", key: "N_prob", kind: "int", min: 1, max: 100, default: 5, value: 8, written: true, meaning: "length of the probation" };
const mics: Field = {
  path: "general.mics", key: "mics", kind: "list", required: true, written: true,
  items: [[{ path: "general.mics[0].mu", key: "mu", kind: "floats", length: 3, value: [0, 0, 0], written: true, required: true }]],
  item: [{ path: "general.mics[].mu", key: "mu", kind: "floats", length: 3, required: true }, { path: "general.mics[].angle", key: "angle", kind: "floats", length: 2, default: [180, 180] }],
};
const group: Field = { path: "sst.kalman", key: "kalman", kind: "group", fields: [{ path: "sst.kalman.sigmaQ", key: "sigmaQ", kind: "float", min: 0, min_excluded: true, default: 0.001, value: 0.001, written: true }] };

test("changed is what stands in the text and says something else", () => {
  assert.ok(isChanged(prob));
  assert.ok(!isChanged({ ...prob, value: 5 }));
  assert.ok(!isChanged({ ...prob, written: false }));
  assert.ok(!isChanged(group));
  assert.equal(countChanged([prob, group, mics]), 2);
});

test("what is typed is refused at the field where it cannot be", () => {
  assert.deepEqual(parseTyped(prob, " 12 "), { value: 12 });
  assert.deepEqual(parseTyped(prob, "12.5"), { problem: "whole" });
  assert.deepEqual(parseTyped(prob, "0"), { problem: "range" });
  assert.deepEqual(parseTyped(prob, "x"), { problem: "number" });
  assert.deepEqual(parseTyped(prob, ""), { problem: "number" });
  assert.deepEqual(parseTyped(group.fields![0]!, "0"), { problem: "range" }, "the bound itself is excluded");
  const mu = mics.items![0]![0]!;
  assert.deepEqual(parseTyped(mu, "0.1, -0.2  3e-2"), { value: [0.1, -0.2, 0.03] });
  assert.deepEqual(parseTyped(mu, "1 2"), { problem: "count" });
  assert.deepEqual(parseTyped({ ...prob, kind: "strings" }, "a, b ,"), { value: ["a", "b"] });
  assert.deepEqual(parseTyped({ ...prob, kind: "string" }, " a "), { value: " a " });
});

test("faults stand at their field; those without one are not lost", () => {
  const faults = [
    { path: "sst.N_prob", what: "too large" }, { path: "general.mics[0].mu", what: "not finite" }, { path: "general.mics[1].mu", what: "same place" },
    { what: "syntax", line: 3 }, { path: "sst.nprob", severity: "warning", what: "unknown" },
  ];
  const form = { sections: [{ name: "sst", fields: [prob, group] }, { name: "general", fields: [mics] }] };
  assert.equal(faultsAt(faults, "sst.N_prob").length, 1);
  assert.equal(faultsAt(faults, "general.mics").length, 0);
  assert.equal(faultsAt(faults, "general.mics", true).length, 2);
  assert.deepEqual(homelessFaults(faults, form).map(({ what }) => what), ["same place", "syntax", "unknown"]);
});

test("a search finds keys and meanings, with the groups around them", () => {
  assert.deepEqual(filterFields([prob, group, mics], "PROBATION"), [prob]);
  assert.equal(filterFields([prob, group], "sigmaq")[0]!.fields!.length, 1);
  assert.deepEqual(filterFields([prob], "nothing"), []);
});

test("a new item has what must be there, or else all that is plain", () => {
  assert.deepEqual(newItem(mics), { mu: [0, 0, 0] });
  const targets: Field = { path: "sst.target", key: "target", kind: "list", item: [{ path: "", key: "tag", kind: "string", default: "" }, { path: "", key: "x", kind: "float", default: 0 }] };
  assert.deepEqual(newItem(targets), { tag: "", x: 0 });
});

test("values are shown as people write them", () => {
  assert.equal(showValue([0.10000000149011612, -1]), "0.1, -1");
  assert.equal(showValue(null), "");
});
