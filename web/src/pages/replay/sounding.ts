// SPDX-License-Identifier: MIT
// Plays one voice of a session in step with the clock of the replay.
import { partAt, type Session } from "../../lib/session";
import { readSound, type Voice } from "../../lib/sound_index";

/** Seconds of the session that are fetched and scheduled at a time, and how far ahead. */
const kPiece = 0.5;
const kAhead = 1;
/** Seconds by which sound and picture may be apart before the sound begins anew. */
const kSlack = 0.08;

/** Index of the sample of `voice` that belongs to `seconds` of the session, or null in another run. */
export function sampleAt(session: Session, voice: Voice, seconds: number): number | null {
  const part = partAt(session, seconds);
  if (!part || session.parts[voice.part] !== part) return null;
  const { run } = part;
  // Separated voices come `voice_delay` late; what is seen is not: the sound is taken from so much further on.
  const late = voice.stream === "raw" ? 0 : (run.voice_delay ?? 0);
  return Math.round((part.firstStamp - 1) * run.hop + (seconds - part.from + late) * voice.rate);
}

export class Sounding {
  private context: AudioContext | null = null;
  private readonly playing = new Set<AudioBufferSourceNode>();
  private turn = 0;
  private speed = 1;
  /** Of the session, and of the context: where this stretch began. */
  private from = 0;
  private began = 0;
  private scheduled = 0;
  private busy = false;
  voice: Voice | null = null;

  constructor(private readonly session: Session) {}

  /** Called with each picture: `position` in the session, and how fast it goes; 0: it stands. */
  follow(position: number, speed: number): void {
    if (!this.voice || speed === 0) return this.silence();
    const context = (this.context ??= new AudioContext());
    if (context.state !== "running") return void context.resume();
    // What is being fetched is waited for: on a slow computer that takes longer than sound and picture may be apart.
    if (this.busy) return;
    const heard = this.from + (context.currentTime - this.began) * this.speed;
    if (this.playing.size === 0 || speed !== this.speed || Math.abs(heard - position) > kSlack * Math.max(1, speed)) {
      this.silence();
      this.speed = speed;
      this.from = this.scheduled = position;
      this.began = context.currentTime;
    }
    if (this.scheduled < position + kAhead * speed) void this.schedule(context, this.voice);
  }

  silence(): void {
    ++this.turn;
    this.busy = false;
    for (const node of this.playing) node.stop();
    this.playing.clear();
  }

  close(): void {
    this.silence();
    void this.context?.close();
  }

  private async schedule(context: AudioContext, voice: Voice): Promise<void> {
    const mine = this.turn;
    this.busy = true;
    const begin = this.scheduled;
    const length = kPiece * Math.max(1, this.speed);
    const first = sampleAt(this.session, voice, begin);
    const sound = first === null ? null : await readSound(this.session.file, voice, first, Math.round(length * voice.rate));
    if (mine !== this.turn) return;
    this.busy = false;
    this.scheduled = begin + length;
    const buffer = context.createBuffer(1, Math.round(length * voice.rate), voice.rate);
    if (sound) buffer.copyToChannel(sound, 0);
    const node = context.createBufferSource();
    node.buffer = buffer;
    node.playbackRate.value = this.speed;
    node.connect(context.destination);
    const at = this.began + (begin - this.from) / this.speed;
    const late = Math.max(0, context.currentTime - at);
    node.start(Math.max(at, context.currentTime), late * this.speed);
    this.playing.add(node);
    node.onended = () => this.playing.delete(node);
  }
}
