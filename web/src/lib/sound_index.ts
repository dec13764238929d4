// SPDX-License-Identifier: MIT
// Where in a session's file the sound of each voice stands: it is read when it is played.
import type { AudioBlock } from "../socket/binary";
import type { StreamName } from "../socket/messages";

const kHeader = 24;

interface Piece {
  /** Index of its first sample since the run began. */
  first: number;
  count: number;
  /** Of its samples in the file. */
  offset: number;
}

export interface Voice {
  stream: StreamName;
  /** Track id, or microphone from 1. */
  source: number;
  /** Index of the part of the session that it is of. */
  part: number;
  rate: number;
  pieces: Piece[];
}

export class SoundIndex {
  private readonly voices = new Map<string, Voice>();

  add(stream: StreamName, part: number, block: AudioBlock, offset: number): void {
    const key = `${part}/${stream}/${block.source}`;
    let voice = this.voices.get(key);
    if (!voice) {
      voice = { stream, source: block.source, part: Math.max(part, 0), rate: block.rate, pieces: [] };
      this.voices.set(key, voice);
    }
    voice.pieces.push({ first: block.first, count: block.samples.length, offset: offset + kHeader });
  }

  list(): Voice[] {
    return [...this.voices.values()];
  }
}

/** `count` samples of a voice from sample `first` on; silence where the file has none. */
export async function readSound(file: Blob, voice: Voice, first: number, count: number): Promise<Float32Array<ArrayBuffer>> {
  const sound = new Float32Array(count);
  const pieces = between(voice.pieces, first, first + count);
  const last = pieces.at(-1);
  if (!last) return sound;
  // One read, with what lies in between: as many reads as blocks take longer than their sound on a busy computer.
  const begin = pieces[0]!.offset;
  const samples = new DataView(await file.slice(begin, last.offset + 2 * last.count).arrayBuffer());
  for (const piece of pieces) {
    const from = Math.max(piece.first, first);
    const to = Math.min(piece.first + piece.count, first + count);
    for (let i = from; i < to; ++i) sound[i - first] = samples.getInt16(piece.offset - begin + 2 * (i - piece.first), true) / 32768;
  }
  return sound;
}

function between(pieces: Piece[], from: number, to: number): Piece[] {
  let low = 0;
  let high = pieces.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (pieces[middle]!.first + pieces[middle]!.count <= from) low = middle + 1;
    else high = middle;
  }
  let end = low;
  while (end < pieces.length && pieces[end]!.first < to) ++end;
  return pieces.slice(low, end);
}
