// SPDX-License-Identifier: MIT
// What the list of recordings shows of what the daemon has.
import type { StreamName, Vec3 } from "../socket/messages";

export interface Recording {
  name: string;
  kind?: "track" | "raw" | string;
  stream?: StreamName;
  track?: number;
  seconds?: number;
  bytes?: number;
  start?: string;
  direction?: Vec3 | null;
  label?: string;
  transcript?: string;
}

export interface Filter {
  kind: "" | "track" | "raw";
  stream: "" | "separated" | "postfiltered";
  text: string;
}

export const kNoFilter: Filter = { kind: "", stream: "", text: "" };

/** Those that `filter` lets through, the newest first. */
export function filterRecordings(all: readonly Recording[], filter: Filter): Recording[] {
  const words = filter.text.trim().toLowerCase().split(/\s+/).filter((word) => word.length > 0);
  return all
    .filter((one) => {
      if (filter.kind && one.kind !== filter.kind) return false;
      if (filter.stream && one.stream !== filter.stream) return false;
      const text = `${one.name} ${one.label ?? ""} ${one.transcript ?? ""} ${one.track ?? ""}`.toLowerCase();
      return words.every((word) => text.includes(word));
    })
    .sort((a, b) => (b.start ?? b.name).localeCompare(a.start ?? a.name));
}

export function recordingUrl(name: string): string {
  return `/api/v1/recordings/${encodeURIComponent(name)}`;
}

/** All of them without `names`. */
export function zipUrl(names: readonly string[]): string {
  const query = names.map((name) => `name=${encodeURIComponent(name)}`).join("&");
  return query ? `/api/v1/recordings.zip?${query}` : "/api/v1/recordings.zip";
}

export function sessionUrl(name: string): string {
  return `/api/v1/sessions/${encodeURIComponent(name)}`;
}

export function exportUrl(name: string, format: string): string {
  return `/api/v1/export/${format}?session=${encodeURIComponent(name)}`;
}
