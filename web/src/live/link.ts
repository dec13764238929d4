// SPDX-License-Identifier: MIT
// The view as a link: filters, layout and time in the query of the hash.
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { place, replaceQuery } from "../shell/router";
import { readFilters, writeFilters } from "./filters";
import type { Preset, View } from "./view";

const kPresets: Preset[] = ["front", "top", "side", "iso"];

export function readView(view: View, query: URLSearchParams): void {
  view.filters.value = readFilters(query);
  const span = Number(query.get("span"));
  if (span >= 1 && span <= 600) view.span.value = span;
  const preset = kPresets.find((name) => name === query.get("view"));
  if (preset) view.look(preset);
  view.follow.value = query.get("follow") === "1";
  view.heat.value = query.get("heat") === "1";
  const time = query.get("time");
  if (time !== null && time !== "" && Number.isFinite(Number(time))) view.held.value = Number(time);
}

export function writeView(view: View, query: URLSearchParams): void {
  const write = (name: string, text: string | null) => (text === null ? query.delete(name) : query.set(name, text));
  writeFilters(view.filters.value, query);
  write("span", view.span.value === 20 ? null : String(view.span.value));
  write("view", view.preset.value.name === "iso" ? null : view.preset.value.name);
  write("follow", view.follow.value ? "1" : null);
  write("heat", view.heat.value ? "1" : null);
  write("time", view.held.value === null ? null : view.held.value.toFixed(2));
}

/** Keeps the address bar at what is seen. */
export function useViewLink(view: View): void {
  useEffect(() => {
    readView(view, place.peek().query);
    let timer: ReturnType<typeof setTimeout> | undefined;
    const stop = effect(() => {
      const query = new URLSearchParams(place.peek().query);
      writeView(view, query);
      clearTimeout(timer);
      timer = setTimeout(() => {
        if (place.peek().route === "live" && query.toString() !== place.peek().query.toString()) replaceQuery(query);
      }, 250);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, []);
}
