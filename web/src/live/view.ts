// SPDX-License-Identifier: MIT
// How the user looks at what is heard: when, what is hidden, what is pointed at. Never touches the engine or a recording.
import { computed, signal } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";

import { inRegion } from "../store/angles";
import type { Store } from "../store/store";
import { kFilters, type Filters } from "./filters";

export const kSpans = [5, 10, 20, 30, 60, 120, 300, 600] as const;

export type Preset = "front" | "top" | "side" | "iso";

export class View {
  /** Seconds of the run at the right end of the charts while the view is held; null: live. */
  readonly held = signal<number | null>(null);
  /** Seconds that the charts show. */
  readonly span = signal<number>(20);
  /** Seconds of the run under the pointer. */
  readonly cursor = signal<number | null>(null);
  readonly hovered = signal<number | null>(null);
  readonly selected = signal<number | null>(null);
  readonly hidden = signal<ReadonlySet<number>>(new Set());
  readonly solo = signal<number | null>(null);
  readonly filters = signal<Filters>(kFilters);
  readonly follow = signal(false);
  readonly heat = signal(false);
  readonly preset = signal<{ name: Preset; asked: number }>({ name: "iso", asked: 0 });
  readonly mic = signal<number | null>(null);
  /** Raised a few times a second while hops come: for words and numbers. */
  readonly pulse = signal(0);

  readonly paused = computed(() => this.held.value !== null);
  /** The track that keys act on. */
  readonly focus = computed(() => this.selected.value);

  constructor(readonly store: Store) {}

  /** Seconds of the run at the right end of the charts. */
  get right(): number {
    return this.held.value ?? this.store.now;
  }

  /** The hop that sphere and cards show: the newest; while held, the one under the pointer or at the right end. -1: none. */
  shownHop(): number {
    const ring = this.store.ring;
    if (this.held.value === null) return ring.end - 1;
    const hop = ring.at((this.cursor.value ?? this.held.value) + ring.period / 2) - 1;
    return hop >= ring.first ? hop : -1;
  }

  shows(id: number): boolean {
    if (!this.filters.value.tracks) return false;
    return this.solo.value !== null ? this.solo.value === id : !this.hidden.value.has(id);
  }

  showsVoice(id: number, az: number, activity: number): boolean {
    const { activity: least, region } = this.filters.value;
    return activity >= least && inRegion(az, region[0], region[1]) && this.shows(id);
  }

  showsPeak(az: number, energy: number): boolean {
    const { potentials, energy: range, region } = this.filters.value;
    return potentials && energy >= range[0] && energy <= range[1] && inRegion(az, region[0], region[1]);
  }

  togglePause(): void {
    this.held.value = this.held.value === null ? this.store.now : null;
  }

  goLive(): void {
    this.held.value = null;
  }

  /** Moves the charts by `seconds`; beyond the newest hop they are live again. */
  scroll(seconds: number): void {
    const ring = this.store.ring;
    if (ring.end === 0) return;
    const oldest = ring.time(ring.first) + Math.min(this.span.value, this.store.now - ring.time(ring.first));
    const next = this.right + seconds;
    this.held.value = next >= this.store.now ? null : Math.max(oldest, next);
  }

  zoom(steps: number): void {
    const nearest = kSpans.findIndex((span) => span >= this.span.value);
    this.span.value = kSpans[Math.max(0, Math.min(kSpans.length - 1, (nearest < 0 ? kSpans.length - 1 : nearest) + steps))]!;
  }

  toggleHidden(id: number): void {
    const next = new Set(this.hidden.value);
    if (!next.delete(id)) next.add(id);
    this.hidden.value = next;
  }

  toggleSolo(id: number): void {
    this.solo.value = this.solo.value === id ? null : id;
  }

  look(name: Preset): void {
    this.follow.value = false;
    this.preset.value = { name, asked: this.preset.value.asked + 1 };
  }

  /** Hops begin anew: nothing that was chosen of the run before applies. */
  forget(): void {
    this.held.value = null;
    this.cursor.value = null;
    this.hovered.value = null;
    this.selected.value = null;
    this.hidden.value = new Set();
    this.solo.value = null;
    this.mic.value = null;
  }
}

export const ViewContext = createContext<View | null>(null);

export function useView(): View {
  const view = useContext(ViewContext);
  if (!view) throw new Error("no view around this component");
  return view;
}
