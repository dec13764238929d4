// SPDX-License-Identifier: MIT
// Writes session files as docs/protocol.md says, for tests: MCAP, without compression, with or without chunks.
import { audio, hello, hops, run, track } from "./fixtures.mjs";

const kMagic = Buffer.from([0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a]);

function text(value) {
  const bytes = Buffer.from(value);
  const head = Buffer.alloc(4);
  head.writeUInt32LE(bytes.length);
  return Buffer.concat([head, bytes]);
}

function u16(value) {
  const bytes = Buffer.alloc(2);
  bytes.writeUInt16LE(value);
  return bytes;
}

function u32(value) {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32LE(value);
  return bytes;
}

function u64(value) {
  const bytes = Buffer.alloc(8);
  bytes.writeBigUInt64LE(BigInt(value));
  return bytes;
}

export function record(op, ...body) {
  const content = Buffer.concat(body);
  return Buffer.concat([Buffer.from([op]), u64(content.length), content]);
}

export function chunk(records, compression = "") {
  const body = Buffer.concat(records);
  return record(6, u64(0), u64(0), u64(body.length), u32(0), text(compression), u64(body.length), body);
}

/** `messages`: [{topic, at (ns), data (a Buffer, or what becomes JSON)}]. */
export function mcap(messages, { chunked = false, footer = true } = {}) {
  const topics = [...new Set(messages.map(({ topic }) => topic))];
  const channels = topics.map((topic, i) => record(4, u16(i + 1), u16(0), text(topic), text(topic.startsWith("audio/") ? "odas" : "json"), u32(0)));
  const body = messages.map(({ topic, at, data }, i) =>
    record(5, u16(topics.indexOf(topic) + 1), u32(i), u64(at), u64(at), Buffer.isBuffer(data) ? data : Buffer.from(JSON.stringify(data))),
  );
  const records = chunked ? [chunk([...channels, ...body])] : [...channels, ...body];
  const end = footer ? [record(15, u32(0)), record(2, u64(0), u64(0), u32(0)), kMagic] : [];
  return Buffer.concat([kMagic, record(1, text("odas"), text("test")), ...records, ...end]);
}

const kStart = 1769860800125000000n;

/**
 * Two voices for `seconds`: 12 at azimuth 40 from the beginning, 13 that walks from -120 on, from 1 s on; the voice of 12 is a tone of
 * 440 Hz, of microphone 1 one of 880 Hz.
 */
export function sessionMessages({ seconds = 4, audioToo = true } = {}) {
  const count = Math.round(seconds * 125);
  const at = (hop) => kStart + BigInt(hop) * 8000000n;
  const messages = [{ topic: "run", at: kStart, data: { ...run({ id: 5, name: "fixture" }) } }];
  const tracks = (t) => {
    const list = [track(0, 12, [40, 10], { level: -22 })];
    if (t > 225) list.push(track(2, 13, [-120 + (t - 225) / 10, -5], { level: -30, category: 1, tag: t < 0 ? "x" : undefined }));
    return list;
  };
  for (const [i, hop] of hops(101, count, tracks, () => [[1, 0, 0, 0.4]]).hops.entries()) {
    messages.push({ topic: "hops", at: at(i), data: hop });
    if (audioToo && i % 4 === 0) {
      const first = (100 + i) * 128;
      const tone = (hz) => Array.from({ length: 512 }, (_, k) => 8000 * Math.sin((2 * Math.PI * hz * (first + k)) / 16000));
      messages.push({ topic: "audio/separated", at: at(i), data: audio({ stream: 0, source: 12, first, samples: tone(440) }) });
      messages.push({ topic: "audio/raw", at: at(i), data: audio({ stream: 2, source: 1, first, samples: tone(880) }) });
    }
  }
  messages.push({ topic: "log", at: at(count - 1), data: { at: "2026-01-31T12:00:04Z", level: "info", text: "the end" } });
  return messages;
}

export function sessionFile(options) {
  return mcap(sessionMessages(options), options);
}

export { hello };
