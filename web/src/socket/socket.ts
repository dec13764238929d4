// SPDX-License-Identifier: MIT
// The connection to the daemon: comes back by itself, a little later after each failure.
import { parseBinary, type AudioBlock } from "./binary";
import type { AudioWish, Message, Topics } from "./messages";
import { Rpc } from "../rpc";
import type { Store } from "../store/store";

const kFirstWait = 250;
const kLongestWait = 5000;

/** Milliseconds before try number `attempt` (from 1): doubled each time, and not at the same moment for every page. */
export function waitBefore(attempt: number, random = Math.random()): number {
  return Math.min(kLongestWait, kFirstWait * 2 ** (attempt - 1)) * (0.75 + 0.5 * random);
}

const kTopics: Topics = { hops: 60, meters: 10, health: 1, beams: 2, log: 2, recordings: 2, events: 10, transcripts: 5 };

export class Connection {
  readonly rpc = new Rpc((text) => this.send(text));
  /** Every block of sound that arrives. */
  onAudio: (block: AudioBlock) => void = () => {};

  private socket: WebSocket | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private audio: AudioWish[] = [];
  private power = 0;
  private closed = false;

  constructor(
    private readonly store: Store,
    private readonly url: string,
  ) {}

  open(): void {
    this.closed = false;
    clearTimeout(this.timer);
    const socket = new WebSocket(this.url);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    socket.onmessage = (event) => this.take(event.data as string | ArrayBuffer);
    socket.onclose = () => this.lost(socket);
  }

  close(): void {
    this.closed = true;
    clearTimeout(this.timer);
    this.socket?.close();
  }

  /** Tries at once instead of waiting. */
  retry(): void {
    if (!this.store.connected.value) this.open();
  }

  /** Which sound this page wants to get; replaces what it wanted before. */
  setAudio(wishes: AudioWish[]): void {
    this.audio = wishes;
    this.subscribe();
  }

  /** Power maps a second; 0: none. */
  setPower(rate: number): void {
    this.power = rate;
    this.subscribe();
  }

  private subscribe(): void {
    const topics: Topics = this.power > 0 ? { ...kTopics, power: this.power } : kTopics;
    this.send(JSON.stringify({ type: "subscribe", topics, potentials: true, audio: this.audio }));
  }

  private send(text: string): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(text);
    return true;
  }

  private take(data: string | ArrayBuffer): void {
    if (typeof data !== "string") {
      const block = parseBinary(data);
      if (block?.kind === "audio") this.onAudio(block);
      else if (block) this.store.receivePower(block);
      return;
    }
    const message = parse(data);
    if (!message) return;
    if (message.type === "reply") this.rpc.answer(message);
    const first = message.type === "hello" && !this.store.connected.value;
    if (first) this.store.log.value = [];
    this.store.receive(message);
    if (first) this.subscribe();
  }

  private lost(socket: WebSocket): void {
    if (socket !== this.socket) return;
    this.store.disconnected();
    this.rpc.abandon();
    if (this.closed) return;
    this.store.attempts.value++;
    this.timer = setTimeout(() => this.open(), waitBefore(this.store.attempts.value));
  }
}

function parse(text: string): Message | null {
  try {
    const message: unknown = JSON.parse(text);
    return typeof message === "object" && message !== null && "type" in message ? (message as Message) : null;
  } catch {
    return null;
  }
}

/** Where the daemon that served this page listens. */
export function liveUrl(from: Location): string {
  return `${from.protocol === "https:" ? "wss" : "ws"}://${from.host}/api/v1/live`;
}
