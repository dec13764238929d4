// SPDX-License-Identifier: MIT
import type { Store } from "../../store/store";

export function Views({ store }: { store: Store }) {
  store.beat.value;
  return <ul class="replay-voices">{store.liveTracks().map((track) => <li key={track.id}>{track.id}</li>)}</ul>;
}
