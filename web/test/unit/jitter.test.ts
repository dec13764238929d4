// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";

import { JitterBuffer, kTarget } from "../../src/audio/jitter";

const kRate = 16000;
const kBlock = 128;

const tone = (index: number, hertz = 440) => 0.5 * Math.sin((2 * Math.PI * hertz * index) / kRate);

function block(first: number, count = kBlock, hertz = 440): Float32Array {
  return Float32Array.from({ length: count }, (_, k) => tone(first + k, hertz));
}

/** Plays `seconds`; before each quantum of 128 samples `feed` may push. */
function play(buffer: JitterBuffer, seconds: number, feed: (quantum: number) => void): Float32Array {
  const quanta = Math.round((seconds * kRate) / 128);
  const out = new Float32Array(quanta * 128);
  for (let k = 0; k < quanta; k++) {
    feed(k);
    buffer.pull(out.subarray(128 * k, 128 * (k + 1)));
  }
  return out;
}

function largestStep(samples: Float32Array): number {
  let largest = 0;
  for (let k = 1; k < samples.length; k++) largest = Math.max(largest, Math.abs(samples[k]! - samples[k - 1]!));
  return largest;
}

const kTone = largestStep(block(0, 1000));

test("what comes in evenly goes out as it came, sample by sample, after the wait", () => {
  const buffer = new JitterBuffer(kRate);
  const out = play(buffer, 2, (k) => buffer.push(block(k * kBlock), k * kBlock));
  const begin = out.findIndex((value) => value !== 0);
  assert.ok(Math.abs(begin / kRate - kTarget) < 0.02, `${begin / kRate}`);
  const start = out.length - 8000;
  const report = buffer.report();
  const index = Math.round(report.index) - out.length;
  for (let k = start; k < out.length; k++) assert.equal(out[k], Math.fround(tone(index + k)));
  assert.equal(report.underruns, 0);
});

test("blocks that arrive by fits and starts are played without a gap", () => {
  const buffer = new JitterBuffer(kRate);
  let sent = 0;
  const out = play(buffer, 3, (k) => {
    if (k % 5 === 4) for (; sent <= k; sent++) buffer.push(block(sent * kBlock), sent * kBlock);
  });
  assert.equal(buffer.report().underruns, 0);
  assert.ok(largestStep(out) < 1.5 * kTone);
});

test("samples that are missing become silence of their length", () => {
  const buffer = new JitterBuffer(kRate);
  const out = play(buffer, 1, (k) => {
    if (k < 40 || k >= 44) buffer.push(block(k * kBlock), k * kBlock);
  });
  assert.equal(buffer.report().missing, 4 * kBlock);
  let zeros = 0;
  let longest = 0;
  for (let k = Math.ceil(kTarget * kRate) + 300; k < out.length; k++) {
    zeros = out[k] === 0 ? zeros + 1 : 0;
    longest = Math.max(longest, zeros);
  }
  assert.ok(Math.abs(longest - 4 * kBlock) <= 2, `${longest}`);
});

test("when nothing comes it is counted, and more is kept waiting from then on", () => {
  const buffer = new JitterBuffer(kRate);
  play(buffer, 0.5, (k) => buffer.push(block(k * kBlock), k * kBlock));
  play(buffer, 0.5, () => {});
  assert.equal(buffer.report().underruns, 1);
  assert.ok(buffer.report().target > kTarget);
});

test("a voice that ends is no underrun", () => {
  const buffer = new JitterBuffer(kRate);
  const out = play(buffer, 1, (k) => {
    if (k < 30) buffer.push(block(k * kBlock), k * kBlock, k === 29);
  });
  assert.equal(buffer.report().underruns, 0);
  assert.equal(buffer.report().played, 30 * kBlock);
  assert.ok(Math.abs(out[out.length - 1]!) < 1e-6);
});

test("a short voice that ended before enough was waiting is heard too", () => {
  const buffer = new JitterBuffer(kRate);
  buffer.push(block(0, 200), 0, true);
  play(buffer, 0.1, () => {});
  assert.equal(buffer.report().played, 200);
});

test("a switch to another stream has no click and nothing of the one before", () => {
  const buffer = new JitterBuffer(kRate);
  const out = play(buffer, 1.5, (k) => {
    if (k === 60) buffer.flush();
    buffer.push(k < 60 ? block(k * kBlock) : block(k * kBlock, kBlock, 700), k * kBlock);
  });
  assert.ok(largestStep(out) < 1.6 * largestStep(block(0, 1000, 700)), `${largestStep(out)}`);
});

for (const [name, ppm] of [["faster", 300], ["slower", -300]] as const) {
  test(`a sender whose clock is ${name} is followed without a gap and without piling up`, () => {
    const buffer = new JitterBuffer(kRate);
    let sent = 0;
    let most = 0;
    play(buffer, 300, (k) => {
      for (; sent * kBlock < (k + 1) * 128 * (1 + ppm * 1e-6); sent++) buffer.push(block(sent * kBlock), sent * kBlock);
      most = Math.max(most, buffer.report().waiting);
    });
    assert.equal(buffer.report().underruns, 0);
    assert.equal(buffer.report().skipped, 0);
    assert.ok(most < kTarget + 0.07, `${most}`);
  });
}

test("a computer that is busy now and then does not make playing faster and slower all the time", () => {
  const buffer = new JitterBuffer(kRate);
  let sent = 0;
  let hasty = 0;
  const calls = 60 * 125;
  play(buffer, 60, (k) => {
    // Every three seconds 80 ms of sound come only when the last of them is there.
    for (; sent <= k && k % 375 >= 10; sent++) buffer.push(block(sent * kBlock), sent * kBlock);
    if (!Number.isInteger(buffer.report().index)) hasty++;
  });
  assert.ok(hasty < 0.2 * calls, `${hasty} of ${calls}`);
  assert.ok(buffer.report().underruns <= 1);
});

test("sound that would come too late is left out", () => {
  const buffer = new JitterBuffer(kRate);
  for (let k = 0; k < 100; k++) buffer.push(block(k * kBlock), k * kBlock);
  assert.ok(buffer.report().waiting < 0.35);
  assert.ok(buffer.report().skipped > 0);
});

test("what piled up before playing began is left out: it plays as it came, and no later than the target", () => {
  const buffer = new JitterBuffer(kRate);
  for (let k = 0; k < 25; k++) buffer.push(block(k * kBlock), k * kBlock);
  const out = play(buffer, 1, (k) => buffer.push(block((25 + k) * kBlock), (25 + k) * kBlock));
  assert.ok(Math.abs(buffer.report().waiting - kTarget) < 0.02, `${buffer.report().waiting}`);
  const index = Math.round(buffer.report().index) - out.length;
  for (let k = 200; k < out.length; k++) assert.equal(out[k], Math.fround(tone(index + k)));
});

test("what comes late and then all at once does not make everything late for long, and is cut without a click", () => {
  const buffer = new JitterBuffer(kRate);
  let sent = 0;
  const out = play(buffer, 5, (k) => {
    if (k >= 125 && k < 145) return;
    for (; sent <= k; sent++) buffer.push(block(sent * kBlock), sent * kBlock);
  });
  const { underruns, waiting, target } = buffer.report();
  assert.equal(underruns, 1);
  assert.ok(waiting < target + 0.06, `${waiting} s wait, ${target} should`);
  assert.ok(largestStep(out) < 0.25, `${largestStep(out)}`);
});
