// SPDX-License-Identifier: MIT
// Recordings and sessions that a daemon would list, and their files.
import { direction } from "./fixtures.mjs";

export function recordings() {
  const base = { kind: "track", stream: "separated", bytes: 320044, label: "", transcript: "" };
  return [
    { ...base, name: "20260131T120412.250Z_source_14.wav", track: 14, seconds: 10, start: "2026-01-31T12:04:12.250Z", direction: direction(34, 12), transcript: "Could you bring me the red cup from the table, please?" },
    { ...base, name: "20260131T120309.000Z_source_13.wav", track: 13, seconds: 6.5, bytes: 208044, start: "2026-01-31T12:03:09.000Z", direction: direction(-120, -4), label: "Ben at the door", stream: "postfiltered" },
    { ...base, name: "20260131T120000.125Z_raw.wav", kind: "raw", stream: "raw", track: undefined, seconds: 62, bytes: 7936044, start: "2026-01-31T12:00:00.125Z", direction: null },
    { ...base, name: "20260131T115900.000Z_source_12.wav", track: 12, seconds: 3.2, bytes: 102444, start: "2026-01-31T11:59:00.000Z", direction: direction(50, 20) },
  ];
}

/** Two bursts of speech, as 400 columns. */
export function peaks(seed = 1) {
  const max = Array.from({ length: 400 }, (_, i) => {
    const talk = Math.max(0, Math.sin((i / 400) * Math.PI * 2.6 + seed)) ** 0.6;
    return talk * (0.12 + 0.4 * Math.abs(Math.sin(i * 0.71 * seed) * Math.sin(i * 0.13 + seed)));
  });
  return { min: max.map((v) => -0.9 * v), max, seconds: 10, rate: 16000 };
}

export function sessions() {
  return [
    { name: "20260131T121500.000Z.mcap", seconds: 184, bytes: 24.1e6, start: "2026-01-31T12:15:00Z", label: "Two talkers in the kitchen", audio: ["separated", "raw"] },
    { name: "20260131T101500.000Z.mcap", seconds: 42.5, bytes: 1.9e6, start: "2026-01-31T10:15:00Z", label: "", audio: [] },
  ];
}

/** A tone, as a WAV of 16 bit. */
export function wav(seconds = 1, rate = 16000) {
  const count = Math.round(seconds * rate);
  const data = Buffer.alloc(44 + 2 * count);
  data.write("RIFF", 0);
  data.writeUInt32LE(36 + 2 * count, 4);
  data.write("WAVEfmt ", 8);
  data.writeUInt32LE(16, 16);
  data.writeUInt16LE(1, 20);
  data.writeUInt16LE(1, 22);
  data.writeUInt32LE(rate, 24);
  data.writeUInt32LE(2 * rate, 28);
  data.writeUInt16LE(2, 32);
  data.writeUInt16LE(16, 34);
  data.write("data", 36);
  data.writeUInt32LE(2 * count, 40);
  for (let i = 0; i < count; ++i) data.writeInt16LE(Math.round(8000 * Math.sin((2 * Math.PI * 440 * i) / rate)), 44 + 2 * i);
  return data;
}

/** Methods for `FakeDaemon.methods` over lists that deletion and renaming change. */
export function fakeRecords({ list = recordings(), all = sessions() } = {}) {
  const state = { list, all };
  const methods = {
    "recordings.list": () => state.list,
    "recordings.peaks": ({ name }) => peaks(1 + (name.charCodeAt(13) % 5)),
    "recordings.rename": ({ name, label }) => {
      state.list = state.list.map((one) => (one.name === name ? { ...one, label } : one));
      return {};
    },
    "recordings.delete": ({ names }) => {
      state.list = state.list.filter((one) => !names.includes(one.name));
      return { deleted: names };
    },
    "sessions.list": () => state.all,
    "sessions.rename": () => ({}),
    "sessions.delete": ({ names }) => {
      state.all = state.all.filter((one) => !names.includes(one.name));
      return { deleted: names };
    },
    "record.start": () => ({ id: 3, name: "20260131T122000.000Z_source_15.wav" }),
    "record.stop": () => ({ names: ["20260131T122000.000Z_source_15.wav"] }),
  };
  return { state, methods };
}
