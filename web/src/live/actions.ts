// SPDX-License-Identifier: MIT
// What buttons and keys do to one voice.
import { say, sayError } from "../shell/toast";
import type { Studio } from "../studio";
import { t } from "./texts";

export function toggleListening(studio: Studio, id: number): void {
  const listener = studio.listener;
  if (!listener) return;
  const wish = listener.wish.value;
  if (wish?.track === id) listener.stop();
  else listener.listen({ stream: wish?.stream === "postfiltered" ? "postfiltered" : "separated", track: id });
}

/** Begins a recording of this voice, from `lookback` before now; ends it where there is one. */
export function toggleRecording(studio: Studio, id: number): void {
  const { store, call } = studio;
  const running = store.recording.value.find((one) => one.track === id);
  if (running) {
    void call("record.stop", { id: running.id }).catch(sayError);
    return;
  }
  const stream = studio.listener?.wish.value?.stream === "postfiltered" ? "postfiltered" : "separated";
  call("record.start", { what: "track", track: id, stream, preroll: store.run.value?.lookback ?? 0 }).then(() => say(t("recordingStarted", { id })), sayError);
}
