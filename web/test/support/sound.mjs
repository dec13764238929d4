// SPDX-License-Identifier: MIT

/** The samples of a WAV of 16 bits and one channel, full scale 1; also where its header is not up to date. */
export function samplesOf(bytes) {
  const data = bytes.indexOf("data") + 8;
  const count = Math.floor((bytes.length - data) / 2);
  return Float32Array.from({ length: count }, (_, i) => bytes.readInt16LE(data + 2 * i) / 32768);
}

/** SI-SDR in dB of `heard` from `at` on against `truth` from `from` on. */
export function siSdr(heard, at, truth, from, count) {
  let cross = 0;
  let power = 0;
  let energy = 0;
  for (let i = 0; i < count; i++) {
    cross += heard[at + i] * truth[from + i];
    power += truth[from + i] ** 2;
    energy += heard[at + i] ** 2;
  }
  const explained = cross ** 2 / Math.max(1e-20, power);
  return 10 * Math.log10(explained / Math.max(1e-12 * energy + 1e-20, energy - explained));
}

/** Where in `truth`, between `from` and `to`, the `count` samples of `heard` from `at` on lie; -1: nowhere. */
function placeOf(heard, at, truth, from, to, count) {
  const probe = 64; // first where 64 samples fit, then all of them
  let place = -1;
  let best = -Infinity;
  for (let start = Math.max(0, from); start + count <= Math.min(truth.length, to + count); start++) {
    let cross = 0;
    let power = 0;
    let energy = 0;
    for (let i = 0; i < probe; i++) {
      cross += heard[at + i] * truth[start + i];
      power += truth[start + i] ** 2;
      energy += heard[at + i] ** 2;
    }
    if (cross <= 0 || power === 0 || energy === 0 || cross ** 2 < 0.99 * power * energy) continue;
    const likeness = siSdr(heard, at, truth, start, count);
    if (likeness > best) [place, best] = [start, likeness];
  }
  return place;
}

/**
 * The SI-SDR in dB of each piece of `count` samples of `heard`, put where it fits `truth` best: clocks of two computers may differ, and
 * a page then plays a little faster or slower for a moment. Pieces that fit nowhere are -Infinity; the first, in which sound fades in,
 * is passed over.
 */
export function piecesAgainst(heard, truth, count) {
  const sure = 20; // dB: a piece that was played faster may be likest at a wrong place, from which none should be followed
  const all = [];
  let expected = -1;
  for (let at = count; at + count <= heard.length; at += count) {
    const scoreOf = (place) => (place < 0 ? -Infinity : siSdr(heard, at, truth, place, count));
    let place = expected < 0 ? -1 : placeOf(heard, at, truth, expected - count / 2, expected + count / 2, count);
    if (scoreOf(place) < sure) place = placeOf(heard, at, truth, 0, truth.length, count);
    all.push(scoreOf(place));
    expected = scoreOf(place) < sure ? -1 : place + count;
  }
  return all;
}
