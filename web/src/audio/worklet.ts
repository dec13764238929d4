// SPDX-License-Identifier: MIT
// Plays in the thread of the sound: nothing that the page does makes it stumble.
import { JitterBuffer } from "./jitter";

/** What the page says: sound, another stream, or that a test wants to have what is played. */
export type ToWorklet = { samples: Float32Array; first: number; last: boolean } | "flush" | "tap";

interface Port {
  onmessage: ((event: { data: ToWorklet }) => void) | null;
  postMessage(message: unknown, transfer?: Transferable[]): void;
}

declare class AudioWorkletProcessor {
  readonly port: Port;
}
declare function registerProcessor(name: string, processor: new () => AudioWorkletProcessor): void;
declare const sampleRate: number;

class Listen extends AudioWorkletProcessor {
  private readonly buffer = new JitterBuffer(sampleRate);
  private tap = false;
  private rounds = 0;

  constructor() {
    super();
    this.port.onmessage = ({ data }) => {
      if (data === "flush") this.buffer.flush();
      else if (data === "tap") this.tap = true;
      else this.buffer.push(data.samples, data.first, data.last);
    };
  }

  process(_inputs: Float32Array[][], outputs: Float32Array[][]): boolean {
    const [first, ...others] = outputs[0]!;
    if (!first) return true;
    this.buffer.pull(first);
    for (const other of others) other.set(first);
    if (this.tap) this.port.postMessage({ tap: first.slice() });
    if (++this.rounds % 16 === 0) this.port.postMessage({ report: this.buffer.report() });
    return true;
  }
}

registerProcessor("listen", Listen);
