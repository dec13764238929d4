// SPDX-License-Identifier: MIT
import type { Look } from "../store/colors";
import type { View } from "./view";

/** A voice as a card shows it, at the moment that is looked at. */
export interface Voice {
  id: number;
  tag: string;
  look: Look;
  az: number;
  el: number;
  activity: number;
  level: number | null;
  category: number;
  /** Seconds since it was born. */
  age: number;
}

export function voicesOf(view: View): Voice[] {
  const { tracks, ring, now } = view.store;
  if (!view.paused.value) {
    return view.store.liveTracks().map((track) => ({ ...track, age: now - track.born }));
  }
  const hop = view.shownHop();
  const voices: Voice[] = [];
  for (let slot = 0; hop >= ring.first && hop >= 0 && slot < ring.slots; slot++) {
    const cell = ring.cell(hop, slot);
    const id = ring.id[cell]!;
    if (id === 0) continue;
    const known = tracks.known.get(id);
    const level = ring.level[cell]!;
    voices.push({
      id,
      tag: known?.tag ?? "dynamic",
      look: tracks.lookOf(id),
      az: ring.az[cell]!,
      el: ring.el[cell]!,
      activity: ring.activity[cell]!,
      level: Number.isNaN(level) ? null : level,
      category: known?.category ?? 0,
      age: ring.time(hop) - (known?.born ?? ring.time(hop)),
    });
  }
  return voices.sort((a, b) => a.id - b.id);
}
