// SPDX-License-Identifier: MIT
// A session in the place of a daemon: the views of the Live page show it and know no difference.
import type { Feed } from "../../lib/replayer";
import { CommandError } from "../../rpc";
import type { AudioWish, Run, WireHop } from "../../socket/messages";
import { Store } from "../../store/store";
import type { Studio } from "../../studio";

export interface ReplayStudio {
  studio: Studio;
  feed: Feed;
}

/** `onWish`: what the views want to hear. */
export function replayStudio(onWish: (wishes: AudioWish[]) => void = () => {}): ReplayStudio {
  const store = new Store();
  let id = 0;
  const feed: Feed = {
    begin(run: Run) {
      // Another id each time: after a jump nothing of what was shown before is true.
      store.receive({ type: "hello", protocol: 1, role: "viewer", capabilities: [], run: { ...run, id: ++id, kind: "replay" } });
      store.receive({ type: "engine", state: "running" });
    },
    hops(hops: WireHop[]) {
      store.receive({ type: "hops", run: id, hops });
    },
  };
  const studio: Studio = {
    store,
    call: (method) => Promise.reject(new CommandError({ code: "forbidden", message: `A replay knows no ${method}.` })),
    setAudio: onWish,
    setPower: () => {},
  };
  return { studio, feed };
}
