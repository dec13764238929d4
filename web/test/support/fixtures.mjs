// SPDX-License-Identifier: MIT
// What a daemon would say: the messages of docs/protocol.md.

export const kRate = 16000;
export const kHop = 128;

/** The unit vector of two angles in degrees. */
export function direction(az, el = 0) {
  const a = (az * Math.PI) / 180;
  const e = (el * Math.PI) / 180;
  return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
}

export const kMics = [
  { position: [-0.032, 0, 0], direction: [0, 0, 1], channel: 1 },
  { position: [0, -0.032, 0], direction: [0, 0, 1], channel: 2 },
  { position: [0.032, 0, 0], direction: [0, 0, 1], channel: 3 },
  { position: [0, 0.032, 0], direction: [0, 0, 1], channel: 4 },
];

export function run(fields = {}) {
  return {
    id: 1, name: "respeaker_usb_4_mic", source: "hw:CARD=Array", kind: "live", rate: kRate, hop: kHop, slots: 4, potentials: 4,
    lookback: 0.304, voice_delay: 0.312, start: "2026-01-31T12:00:00.125Z", config_hash: "9f86d081", mics: kMics, power_grid: [], targets: [],
    ...fields,
  };
}

export function hello(fields = {}) {
  return {
    type: "hello", protocol: 1, server: "odas 0.4.0", role: "operator",
    capabilities: ["record", "sessions", "config", "engine", "targets", "power", "transcripts"],
    recordings: "/srv/odas/recordings", open_session: null, camera: null, run: run(), ...fields,
  };
}

/** One track of a hop; `at` is [azimuth, elevation]. */
export function track(slot, id, at, { activity = 0.9, level = -24, category = 2, tag } = {}) {
  const result = [slot, id, ...direction(...at), activity, level, category];
  return tag ? [...result, tag] : result;
}

export function potential(at, energy) {
  return [...direction(...at), energy];
}

/** Hops `from`...`from + count - 1`; `tracks(t)` and `potentials(t)` give what each holds. */
export function hops(from, count, tracks = () => [], potentials = () => []) {
  return { type: "hops", run: 1, hops: Array.from({ length: count }, (_, k) => ({ t: from + k, tracks: tracks(from + k), potentials: potentials(from + k) })) };
}

export const kEngine = { type: "engine", state: "running", what: "" };

export function health(fields = {}) {
  return {
    type: "health", hops: 12000, hop_p50_us: 410, hop_p99_us: 890, hop_max_us: 2100, real_time_share: 0.051, dropped_hops: 0, lost_records: 0, overruns: 0,
    lost_frames: 0, clipped_samples: 0, cpu: 0.062, rss_bytes: 41e6, temperature: 48.5, clients: 1, client_dropped: 0, latency: 0.018,
    stages: [["transform", 18.4], ["noise", 6.2], ["localization", 190], ["tracking", 41], ["separation", 118], ["synthesis", 9.7], ["post_filter", 27]], ...fields,
  };
}

/** `all`: of each voice [track, SNR, white-noise gain, condition]. */
export function beams(all) {
  return { type: "beams", run: 1, t: 100, beams: all.map((beam, slot) => [slot, ...beam]) };
}

export function meters(mics = [[-38, -21, 0], [-37, -20, 0], [-39, -22, 0], [-38, -21, 0]]) {
  return { type: "meters", t: 100, mics };
}

/** A block of sound, as bytes. */
export function audio({ stream = 0, source = 1, first = 0, rate = kRate, samples, flags = 0 }) {
  const data = Buffer.alloc(24 + 2 * samples.length);
  data.writeUInt8(1, 0);
  data.writeUInt8(1, 1);
  data.writeUInt8(1, 2);
  data.writeUInt8(stream, 3);
  data.writeUInt32LE(source, 4);
  data.writeBigUInt64LE(BigInt(first), 8);
  data.writeUInt32LE(rate, 16);
  data.writeUInt16LE(samples.length, 20);
  data.writeUInt16LE(flags, 22);
  samples.forEach((sample, k) => data.writeInt16LE(Math.max(-32768, Math.min(32767, Math.round(sample))), 24 + 2 * k));
  return data;
}

/** A power map of `values` (0...255), as bytes. */
export function power(t, values, scale = 1) {
  const data = Buffer.alloc(24 + values.length);
  data.writeUInt8(2, 0);
  data.writeUInt8(1, 1);
  data.writeUInt8(1, 2);
  data.writeUInt32LE(values.length, 4);
  data.writeBigUInt64LE(BigInt(t), 8);
  data.writeFloatLE(scale, 16);
  Buffer.from(values).copy(data, 24);
  return data;
}
