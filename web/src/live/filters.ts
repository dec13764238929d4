// SPDX-License-Identifier: MIT
// What is left out of the picture, and how a link says it.

export interface Filters {
  tracks: boolean;
  potentials: boolean;
  /** Potentials outside of it are hidden, at both ends. */
  energy: readonly [number, number];
  /** Tracks less active than this are hidden. */
  activity: number;
  /** Azimuths in degrees, from the first up to the second; equal: everywhere. */
  region: readonly [number, number];
}

export const kFilters: Filters = { tracks: true, potentials: true, energy: [0, 1], activity: 0, region: [-180, 180] };

function within(text: string | null, low: number, high: number, otherwise: number): number {
  const value = text === null || text === "" ? NaN : Number(text);
  return Number.isFinite(value) ? Math.min(high, Math.max(low, value)) : otherwise;
}

function pair(text: string | null, low: number, high: number, otherwise: readonly [number, number]): readonly [number, number] {
  if (text === null) return otherwise;
  const [first = null, second = null] = text.split("~");
  return [within(first, low, high, otherwise[0]), within(second, low, high, otherwise[1])];
}

/** Whatever a link says, in bounds. */
export function readFilters(query: URLSearchParams): Filters {
  const energy = pair(query.get("energy"), 0, 1, kFilters.energy);
  return {
    tracks: query.get("tracks") !== "0",
    potentials: query.get("potentials") !== "0",
    energy: energy[0] <= energy[1] ? energy : [energy[1], energy[0]],
    activity: within(query.get("activity"), 0, 1, kFilters.activity),
    region: pair(query.get("region"), -180, 180, kFilters.region),
  };
}

/** Only what differs from the usual is written. */
export function writeFilters(filters: Filters, query: URLSearchParams): void {
  const write = (name: string, text: string, usual: boolean) => (usual ? query.delete(name) : query.set(name, text));
  write("tracks", "0", filters.tracks);
  write("potentials", "0", filters.potentials);
  write("energy", filters.energy.join("~"), filters.energy[0] === 0 && filters.energy[1] === 1);
  write("activity", String(filters.activity), filters.activity === 0);
  write("region", filters.region.join("~"), filters.region[0] === -180 && filters.region[1] === 180);
}
