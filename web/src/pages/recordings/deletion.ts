// SPDX-License-Identifier: MIT
// Files that were confirmed to go stay for a few seconds more, in which that can be taken back.
import { signal } from "@preact/signals";

const kGrace = 5000;

export class Deletion {
  /** Names that are about to go: not shown any more, still there. */
  readonly names = signal<string[]>([]);
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly run: (names: string[]) => void) {}

  begin(names: string[]): void {
    this.flush();
    this.names.value = names;
    this.timer = setTimeout(() => this.flush(), kGrace);
  }

  undo(): void {
    clearTimeout(this.timer);
    this.names.value = [];
  }

  /** Without waiting any longer: something else is to be deleted, or the page is left. */
  flush(): void {
    clearTimeout(this.timer);
    const names = this.names.value;
    if (names.length > 0) this.run(names);
  }

  /** They are gone, or could not be deleted. */
  done(names: string[]): void {
    if (this.names.value === names) this.names.value = [];
  }
}
