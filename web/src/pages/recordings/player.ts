// SPDX-License-Identifier: MIT
// One recording at a time, played by the browser from the daemon, which sends the part that is asked for.
import { signal } from "@preact/signals";

import { recordingUrl } from "../../lib/recording_list";

export class Player {
  readonly name = signal<string | null>(null);
  readonly playing = signal(false);
  readonly seconds = signal(0);
  private readonly audio = new Audio();
  private frame = 0;

  constructor(onError: (name: string) => void) {
    this.audio.preload = "metadata";
    this.audio.onplay = () => {
      this.playing.value = true;
      this.follow();
    };
    this.audio.onpause = () => {
      this.playing.value = false;
    };
    this.audio.onseeked = () => this.look();
    this.audio.onended = () => this.look();
    this.audio.onerror = () => {
      if (this.name.value && this.audio.src) onError(this.name.value);
      this.playing.value = false;
    };
  }

  toggle(name: string): void {
    if (this.name.value === name && this.playing.value) return this.audio.pause();
    this.choose(name);
    void this.audio.play().catch(() => {});
  }

  seek(name: string, seconds: number): void {
    this.choose(name);
    this.audio.currentTime = seconds;
    this.seconds.value = seconds;
  }

  close(): void {
    cancelAnimationFrame(this.frame);
    this.name.value = null;
    this.audio.pause();
    this.audio.removeAttribute("src");
    this.audio.load();
  }

  private choose(name: string): void {
    if (this.name.value === name) return;
    this.name.value = name;
    this.seconds.value = 0;
    this.audio.src = recordingUrl(name);
  }

  private look(): void {
    this.seconds.value = this.audio.currentTime;
  }

  private follow(): void {
    this.look();
    cancelAnimationFrame(this.frame);
    if (this.playing.value) this.frame = requestAnimationFrame(() => this.follow());
  }
}
