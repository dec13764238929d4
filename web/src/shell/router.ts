// SPDX-License-Identifier: MIT
// Routes are hashes, `#/live?name=value`: a link to what is seen needs nothing of the daemon.
import { signal } from "@preact/signals";

export const kRoutes = ["live", "recordings", "replay", "configuration", "health"] as const;

export type Route = (typeof kRoutes)[number];

export interface Place {
  route: Route;
  query: URLSearchParams;
}

export function parsePlace(hash: string): Place {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?", 2);
  const route = kRoutes.find((name) => name === path) ?? "live";
  return { route, query: new URLSearchParams(query) };
}

export const place = signal<Place>(parsePlace(globalThis.location?.hash ?? ""));

export function followPlace(): void {
  addEventListener("hashchange", () => {
    place.value = parsePlace(location.hash);
  });
}

export function linkTo(route: Route, query?: URLSearchParams): string {
  const text = query?.toString();
  return text ? `#/${route}?${text}` : `#/${route}`;
}

/** Replaces the query of this route without a new entry in the history. */
export function replaceQuery(query: URLSearchParams): void {
  history.replaceState(null, "", linkTo(place.value.route, query));
  place.value = { route: place.value.route, query };
}

/** `?kiosk` before the hash: no bars, only what is heard. `?test=1`: read-only counters for tests. */
export const kiosk = new URLSearchParams(globalThis.location?.search ?? "").has("kiosk");
export const testing = new URLSearchParams(globalThis.location?.search ?? "").get("test") === "1";
