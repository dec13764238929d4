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

/** The SI-SDR of the piece of `count` samples of `heard` that fits `truth` best, at whatever place of it. */
export function bestDecibels(heard, truth, count) {
  let best = -Infinity;
  for (let at = Math.floor(count / 2); at + count <= heard.length; at += count) {
    const probe = 64; // first where 64 samples fit, then all of the piece
    for (let from = 0; from + count <= truth.length; from++) {
      let cross = 0;
      let power = 0;
      let energy = 0;
      for (let i = 0; i < probe; i++) {
        cross += heard[at + i] * truth[from + i];
        power += truth[from + i] ** 2;
        energy += heard[at + i] ** 2;
      }
      if (cross <= 0 || power === 0 || energy === 0 || cross ** 2 < 0.99 * power * energy) continue;
      best = Math.max(best, siSdr(heard, at, truth, from, count));
    }
  }
  return best;
}
