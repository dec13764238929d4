// SPDX-License-Identifier: MIT
// Two ways to the loudspeaker: a worklet where the page is secure (https, or this computer), scheduled buffers elsewhere.
import { JitterBuffer, type JitterReport } from "./jitter";
import type { ToWorklet } from "./worklet";

export interface Output {
  readonly kind: "worklet" | "buffers";
  push(samples: Float32Array, first: number, last: boolean): void;
  flush(): void;
  close(): void;
}

export interface OutputHooks {
  report: (report: JitterReport) => void;
  /** Everything that is played, for tests; null: nobody asks. */
  tap: ((samples: Float32Array) => void) | null;
}

export async function makeOutput(context: AudioContext, into: AudioNode, hooks: OutputHooks): Promise<Output> {
  if (context.audioWorklet) {
    try {
      await context.audioWorklet.addModule("listen-worklet.js");
      return new WorkletOutput(context, into, hooks);
    } catch {
      // As if there were none.
    }
  }
  return new BufferOutput(context, into, hooks);
}

class WorkletOutput implements Output {
  readonly kind = "worklet";
  private readonly node: AudioWorkletNode;

  constructor(context: AudioContext, into: AudioNode, hooks: OutputHooks) {
    this.node = new AudioWorkletNode(context, "listen", { numberOfInputs: 0, outputChannelCount: [1] });
    this.node.port.onmessage = ({ data }: MessageEvent<{ report?: JitterReport; tap?: Float32Array }>) => {
      if (data.report) hooks.report(data.report);
      if (data.tap) hooks.tap?.(data.tap);
    };
    if (hooks.tap) this.say("tap");
    this.node.connect(into);
  }

  push(samples: Float32Array, first: number, last: boolean): void {
    this.say({ samples, first, last }, [samples.buffer]);
  }

  flush(): void {
    this.say("flush");
  }

  close(): void {
    this.node.disconnect();
    this.node.port.close();
  }

  private say(message: ToWorklet, transfer: Transferable[] = []): void {
    this.node.port.postMessage(message, transfer);
  }
}

/** Seconds of one scheduled piece, and how far ahead pieces are scheduled. */
const kPiece = 0.02;
const kAhead = 0.06;

class BufferOutput implements Output {
  readonly kind = "buffers";
  private readonly buffer: JitterBuffer;
  private readonly size: number;
  private readonly timer: ReturnType<typeof setInterval>;
  /** Samples scheduled since `origin`, so that pieces follow one another without a rounding. */
  private scheduled = 0;
  private origin: number;
  private rounds = 0;

  constructor(
    private readonly context: AudioContext,
    private readonly into: AudioNode,
    private readonly hooks: OutputHooks,
  ) {
    this.buffer = new JitterBuffer(context.sampleRate);
    this.size = Math.round(kPiece * context.sampleRate);
    this.origin = context.currentTime + 0.02;
    this.timer = setInterval(() => this.pump(), 10);
  }

  push(samples: Float32Array, first: number, last: boolean): void {
    this.buffer.push(samples, first, last);
    // Timers of a tab in the background sleep; what arrives wakes us.
    this.pump();
  }

  flush(): void {
    this.buffer.flush();
  }

  close(): void {
    clearInterval(this.timer);
  }

  private pump(): void {
    const now = this.context.currentTime;
    const rate = this.context.sampleRate;
    if (this.context.state !== "running") return;
    if (this.origin + this.scheduled / rate < now) {
      this.origin = now + 0.01;
      this.scheduled = 0;
    }
    while (this.origin + this.scheduled / rate < now + kAhead) {
      const piece = new Float32Array(this.size);
      this.buffer.pull(piece);
      const sound = this.context.createBuffer(1, this.size, rate);
      sound.copyToChannel(piece, 0);
      const source = this.context.createBufferSource();
      source.buffer = sound;
      source.connect(this.into);
      source.start(this.origin + this.scheduled / rate);
      this.scheduled += this.size;
      this.hooks.tap?.(piece);
      if (++this.rounds % 6 === 0) this.hooks.report({ ...this.buffer.report(), waiting: this.buffer.report().waiting + kAhead });
    }
  }
}
