// SPDX-License-Identifier: MIT
// What every component can reach: a store, and the ways to ask for something. A replay gives the same with its own store.
import { createContext } from "preact";
import { useContext } from "preact/hooks";

import type { AudioDesk } from "./audio/desk";
import type { Listener } from "./audio/listener";
import type { AudioWish } from "./socket/messages";
import type { Store } from "./store/store";

export interface Studio {
  store: Store;
  /** Runs a command; rejects with a `CommandError` (rpc.ts). */
  call<Result = unknown>(method: string, params?: object): Promise<Result>;
  setAudio(wishes: AudioWish[]): void;
  setPower(rate: number): void;
  /** Hears what `setAudio` asked for; without one, nothing can be heard. */
  listener?: Listener;
  /** Sound for more than the ear: pictures of it. */
  desk?: AudioDesk;
}

export const StudioContext = createContext<Studio | null>(null);

export function useStudio(): Studio {
  const studio = useContext(StudioContext);
  if (!studio) throw new Error("no studio around this component");
  return studio;
}

export function useStore(): Store {
  return useStudio().store;
}
