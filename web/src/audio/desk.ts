// SPDX-License-Identifier: MIT
// Several parts of the page want sound at once: the daemon is told of all of it, and each part gets what it asked for.
import type { AudioBlock } from "../socket/binary";
import type { AudioWish } from "../socket/messages";

export class AudioDesk {
  private readonly wishes = new Map<string, AudioWish[]>();
  private readonly takers = new Set<(block: AudioBlock) => void>();

  /** `ask` tells who sends sound what is wanted. */
  constructor(private readonly ask: (wishes: AudioWish[]) => void) {}

  /** Replaces what `owner` wants; [] : nothing any more. */
  want(owner: string, wishes: AudioWish[]): void {
    this.wishes.set(owner, wishes);
    const all = [...this.wishes.values()].flat();
    const key = ({ stream, track, mic }: AudioWish) => `${stream}/${track ?? ""}/${mic ?? ""}`;
    this.ask([...new Map(all.map((wish) => [key(wish), wish])).values()]);
  }

  /** Every block that arrives, until the returned function is called. */
  listen(take: (block: AudioBlock) => void): () => void {
    this.takers.add(take);
    return () => this.takers.delete(take);
  }

  take(block: AudioBlock): void {
    for (const taker of this.takers) taker(block);
  }
}
