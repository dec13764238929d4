// SPDX-License-Identifier: MIT
// Reads MCAP files (https://mcap.dev/spec) from front to back, without compression, by slices: a file of any size, complete or cut.

const kMagic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
const kWindow = 1 << 20;
/** More than any record that a Studio writes; a damaged length must not make us wait for 4 GB. */
const kLargest = 256 << 20;

export const McapOp = { header: 1, footer: 2, schema: 3, channel: 4, message: 5, chunk: 6, dataEnd: 15 } as const;

export interface McapMessage {
  topic: string;
  /** Nanoseconds since 1970, UTC. */
  logTime: bigint;
  /** Valid during the call only: copy what is to be kept. */
  data: Uint8Array;
  /** Where `data` begins in the file. */
  offset: number;
}

/** Why a file was not read to its end. */
export type McapFault = "not_mcap" | "cut" | "damaged" | "compressed";

export interface McapEnd {
  fault: McapFault | null;
  /** Bytes that could be read. */
  read: number;
}

/** Calls `take` for every message in the order of the file. Never throws for what the file holds. */
export async function readMcap(
  file: Blob,
  take: (message: McapMessage) => void,
  progress: (share: number) => void = () => {},
): Promise<McapEnd> {
  const window = new Window(file);
  const magic = await window.bytes(0, kMagic.length);
  if (!magic || !kMagic.every((byte, i) => magic[i] === byte)) return { fault: "not_mcap", read: 0 };
  const topics = new Map<number, string>();
  let at = kMagic.length;
  for (;;) {
    const head = await window.bytes(at, 9);
    if (!head) return { fault: "cut", read: at };
    const length = Number(viewOf(head).getBigUint64(1, true));
    if (head[0] === 0 || length > kLargest) return { fault: "damaged", read: at };
    const body = await window.bytes(at + 9, length);
    if (!body) return { fault: "cut", read: at };
    const fault = takeRecord(head[0]!, body, at + 9, topics, take);
    if (fault) return { fault, read: at };
    at += 9 + length;
    progress(at / file.size);
    if (head[0] === McapOp.footer) return { fault: null, read: at };
  }
}

function takeRecord(
  op: number,
  body: Uint8Array,
  offset: number,
  topics: Map<number, string>,
  take: (message: McapMessage) => void,
): McapFault | null {
  try {
    if (op === McapOp.channel) takeChannel(body, topics);
    else if (op === McapOp.message) takeMessage(body, offset, topics, take);
    else if (op === McapOp.chunk) return takeChunk(body, offset, topics, take);
    return null;
  } catch (error) {
    if (error instanceof RangeError) return "damaged";
    throw error;
  }
}

function takeChannel(body: Uint8Array, topics: Map<number, string>): void {
  const view = viewOf(body);
  const length = view.getUint32(4, true);
  if (8 + length > body.length) throw new RangeError();
  topics.set(view.getUint16(0, true), new TextDecoder().decode(body.subarray(8, 8 + length)).replace(/^\//, ""));
}

function takeMessage(
  body: Uint8Array,
  offset: number,
  topics: Map<number, string>,
  take: (message: McapMessage) => void,
): void {
  const view = viewOf(body);
  const topic = topics.get(view.getUint16(0, true));
  const logTime = view.getBigUint64(6, true);
  if (topic !== undefined && body.length >= 22) take({ topic, logTime, data: body.subarray(22), offset: offset + 22 });
}

function takeChunk(
  body: Uint8Array,
  offset: number,
  topics: Map<number, string>,
  take: (message: McapMessage) => void,
): McapFault | null {
  const view = viewOf(body);
  const name = view.getUint32(28, true);
  if (name > 0) return "compressed";
  let at = 32 + 8;
  const end = at + Number(view.getBigUint64(32, true));
  while (at + 9 <= end) {
    const length = Number(view.getBigUint64(at + 1, true));
    const record = body.subarray(at + 9, at + 9 + length);
    if (record.length < length || body[at] === 0) return "damaged";
    const fault = takeRecord(body[at]!, record, offset + at + 9, topics, take);
    if (fault) return fault;
    at += 9 + length;
  }
  return null;
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/** A piece of the file in memory, that moves on. */
class Window {
  private held = new Uint8Array(0);
  private start = 0;

  constructor(private readonly file: Blob) {}

  /** `null`: the file ends before. */
  async bytes(from: number, count: number): Promise<Uint8Array | null> {
    if (from + count > this.file.size) return null;
    if (from < this.start || from + count > this.start + this.held.length) {
      const slice = this.file.slice(from, from + Math.max(count, kWindow));
      this.held = new Uint8Array(await slice.arrayBuffer());
      this.start = from;
    }
    return this.held.subarray(from - this.start, from - this.start + count);
  }
}
