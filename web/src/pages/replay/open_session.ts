// SPDX-License-Identifier: MIT
import { effect } from "@preact/signals";

import { linkTo, place } from "../../shell/router";
import type { Store } from "../../store/store";

/** A daemon that was started with a session (`odas studio SESSION`) leads to it, once. */
export function followOpenSession(store: Store): () => void {
  let led = "";
  return effect(() => {
    const name = store.hello.value?.open_session;
    if (!name || name === led) return;
    led = name;
    const { route, query } = place.peek();
    if (route !== "replay" || !query.has("session")) location.hash = linkTo("replay", new URLSearchParams({ session: name }));
  });
}
