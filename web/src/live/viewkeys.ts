// SPDX-License-Identifier: MIT
import { useKeys, type Binding } from "../shell/keys";
import type { Studio } from "../studio";
import { toggleListening, toggleRecording } from "./actions";
import { t } from "./texts";
import type { Preset, View } from "./view";
import { voicesOf } from "./voices";

const kPresets: Record<string, Preset> = { "1": "front", "2": "top", "3": "side", "4": "iso" };

/** The voice that was chosen; else the only or first one. */
function chosen(view: View): number | null {
  const voices = voicesOf(view);
  const selected = view.selected.value;
  if (selected !== null && (view.hidden.value.has(selected) || voices.some((voice) => voice.id === selected))) return selected;
  return voices[0]?.id ?? null;
}

function step(view: View, by: number): void {
  const ids = voicesOf(view).map((voice) => voice.id);
  if (ids.length === 0) return;
  const at = view.selected.value === null ? -1 : ids.indexOf(view.selected.value);
  const next = at < 0 ? (by > 0 ? 0 : ids.length - 1) : (at + by + ids.length) % ids.length;
  view.selected.value = ids[next]!;
  document.querySelector<HTMLElement>(`[data-voice="${ids[next]}"]`)?.scrollIntoView({ block: "nearest" });
}

export function useViewKeys(view: View, studio: Studio): void {
  const group = () => t("liveKeys");
  const toVoice = (act: (id: number) => void) => () => {
    const id = chosen(view);
    if (id === null) return;
    view.selected.value = id;
    act(id);
  };
  useKeys((): Binding[] => [
    { keys: [" "], label: t("spaceKey"), meaning: () => t("keyPause"), group, run: () => view.togglePause() },
    { keys: Object.keys(kPresets), label: "1 – 4", meaning: () => t("keyViews"), group, run: (event) => view.look(kPresets[event.key]!) },
    { keys: ["ArrowUp", "ArrowDown"], label: "↑ ↓", meaning: () => t("keySource"), group, run: (event) => step(view, event.key === "ArrowDown" ? 1 : -1) },
    { keys: ["h"], label: "H", meaning: () => t("keyHide"), group, run: toVoice((id) => view.toggleHidden(id)) },
    { keys: ["s"], label: "S", meaning: () => t("keySolo"), group, run: toVoice((id) => view.toggleSolo(id)) },
    { keys: ["l"], label: "L", meaning: () => t("keyListen"), group, run: toVoice((id) => toggleListening(studio, id)) },
    { keys: ["r"], label: "R", meaning: () => t("keyRecord"), group, run: toVoice((id) => { if (studio.store.operator.value) toggleRecording(studio, id); }) },
    { keys: ["f"], label: "F", meaning: () => t("keyFollow"), group, run: () => { view.follow.value = !view.follow.value; } },
    { keys: ["+", "=", "-"], label: "+ −", meaning: () => t("keyZoom"), group, run: (event) => view.zoom(event.key === "-" ? 1 : -1) },
    { keys: ["ArrowLeft", "ArrowRight"], label: "← →", meaning: () => t("keyScroll"), group, run: (event) => view.scroll((event.key === "ArrowLeft" ? -0.25 : 0.25) * view.span.value) },
    { keys: ["End"], label: "End", meaning: () => t("keyLive"), group, run: () => view.goLive() },
  ]);
}
