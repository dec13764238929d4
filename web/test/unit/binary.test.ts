// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { encodeAudio, parseBinary } from "../../src/socket/binary";
import { audio, power } from "../support/fixtures.mjs";

function bytes(data: Buffer): ArrayBuffer {
  return data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength) as ArrayBuffer;
}

test("a block of sound is read as it was written", () => {
  const block = parseBinary(bytes(audio({ stream: 1, source: 77, first: 2 ** 40, samples: [1, -2, 32767], flags: 3 })));
  assert.ok(block?.kind === "audio");
  assert.deepEqual({ ...block, samples: [...block.samples] }, { kind: "audio", stream: "postfiltered", source: 77, first: 2 ** 40, rate: 16000, samples: [1, -2, 32767], gap: true, last: true });
  assert.deepEqual(parseBinary(encodeAudio(block)), block);
});

test("a power map is read as it was written", () => {
  const map = parseBinary(bytes(power(9, [0, 128, 255], 0.5)));
  assert.ok(map?.kind === "power");
  assert.deepEqual([map.t, map.scale, [...map.values]], [9, 0.5, [0, 128, 255]]);
});

test("what was cut or is not known is passed over", () => {
  const whole = audio({ samples: [1, 2, 3] });
  for (let length = 0; length < whole.length; length++) assert.equal(parseBinary(bytes(whole.subarray(0, length))), null);
  for (const at of [0, 1, 2, 3]) {
    const strange = Buffer.from(whole);
    strange[at] = 99;
    assert.equal(parseBinary(bytes(strange)), null);
  }
});
