// SPDX-License-Identifier: MIT
// The daemon's binary messages: 24 bytes of header, little-endian, then the payload.
import type { StreamName } from "./messages";

const kHeader = 24;
const kStreams: StreamName[] = ["separated", "postfiltered", "raw"];

export interface AudioBlock {
  kind: "audio";
  stream: StreamName;
  /** The track's id; of `raw` the microphone, from 1. */
  source: number;
  /** Index of the first sample since the start of the run. */
  first: number;
  /** Hz */
  rate: number;
  samples: Int16Array;
  /** Samples are missing before these. */
  gap: boolean;
  /** The last of this track. */
  last: boolean;
}

export interface PowerMap {
  kind: "power";
  /** Time stamp of its hop. */
  t: number;
  scale: number;
  /** One value for each direction of `run.power_grid`: E = value / 255 x scale. */
  values: Uint8Array;
}

/** Null for what this page does not know: another type, version or format, or a message that was cut. */
export function parseBinary(data: ArrayBuffer): AudioBlock | PowerMap | null {
  if (data.byteLength < kHeader) return null;
  const view = new DataView(data);
  if (view.getUint8(1) !== 1) return null;
  if (view.getUint8(0) === 1) return parseAudio(data, view);
  if (view.getUint8(0) === 2) return parsePower(data, view);
  return null;
}

function parseAudio(data: ArrayBuffer, view: DataView): AudioBlock | null {
  const stream = kStreams[view.getUint8(3)];
  const count = view.getUint16(20, true);
  if (view.getUint8(2) !== 1 || !stream || data.byteLength < kHeader + 2 * count) return null;
  const flags = view.getUint16(22, true);
  return {
    kind: "audio",
    stream,
    source: view.getUint32(4, true),
    first: Number(view.getBigUint64(8, true)),
    rate: view.getUint32(16, true),
    samples: new Int16Array(data, kHeader, count),
    gap: (flags & 1) !== 0,
    last: (flags & 2) !== 0,
  };
}

function parsePower(data: ArrayBuffer, view: DataView): PowerMap | null {
  const count = view.getUint32(4, true);
  if (view.getUint8(2) !== 1 || data.byteLength < kHeader + count) return null;
  return {
    kind: "power",
    t: Number(view.getBigUint64(8, true)),
    scale: view.getFloat32(16, true),
    values: new Uint8Array(data, kHeader, count),
  };
}

/** The same, backwards: for tests and for replaying. */
export function encodeAudio(block: Omit<AudioBlock, "kind">): ArrayBuffer {
  const data = new ArrayBuffer(kHeader + 2 * block.samples.length);
  const view = new DataView(data);
  view.setUint8(0, 1);
  view.setUint8(1, 1);
  view.setUint8(2, 1);
  view.setUint8(3, kStreams.indexOf(block.stream));
  view.setUint32(4, block.source, true);
  view.setBigUint64(8, BigInt(block.first), true);
  view.setUint32(16, block.rate, true);
  view.setUint16(20, block.samples.length, true);
  view.setUint16(22, (block.gap ? 1 : 0) | (block.last ? 2 : 0), true);
  new Int16Array(data, kHeader).set(block.samples);
  return data;
}
