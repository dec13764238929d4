// SPDX-License-Identifier: MIT
// What sphere and flat map show at one moment: voices, their trails, potentials. Pure: both draw the same.
import { direction } from "../../store/angles";
import type { Look } from "../../store/colors";
import type { Vec3 } from "../../socket/messages";
import type { View } from "../view";

/** Seconds that a trail and a potential stay. */
export const kTrail = 1.5;
export const kGlow = 0.5;

export interface Ball {
  id: number;
  look: Look;
  az: number;
  el: number;
  activity: number;
  /** From the oldest to the newest, azimuth and elevation in turn. */
  trail: number[];
}

export interface Spark {
  az: number;
  el: number;
  energy: number;
  /** 0 now, 1 about to vanish. */
  age: number;
}

export interface Frame {
  balls: Ball[];
  sparks: Spark[];
}

export function frameOf(view: View): Frame {
  const frame: Frame = { balls: [], sparks: [] };
  const store = view.store;
  const ring = store.ring;
  const hop = view.shownHop();
  if (hop < ring.first || hop < 0) return frame;
  const gone = !view.paused.value && store.tracks.live.size === 0;
  const from = Math.max(ring.first, hop - Math.round(kTrail / ring.period));
  for (let slot = 0; !gone && slot < ring.slots; slot++) {
    const cell = ring.cell(hop, slot);
    const id = ring.id[cell]!;
    if (id === 0 || !view.showsVoice(id, ring.az[cell]!, ring.activity[cell]!)) continue;
    const trail: number[] = [];
    const stride = Math.max(1, Math.floor((hop - from) / 60));
    for (let k = hop; k >= from && ring.id[ring.cell(k, slot)] === id; k -= stride) trail.unshift(ring.az[ring.cell(k, slot)]!, ring.el[ring.cell(k, slot)]!);
    frame.balls.push({ id, look: store.tracks.lookOf(id), az: ring.az[cell]!, el: ring.el[cell]!, activity: ring.activity[cell]!, trail });
  }
  const recent = Math.max(ring.first, hop - Math.round(kGlow / ring.period));
  for (let k = recent; k <= hop && !(gone && store.link.value !== "live"); k++) {
    for (let n = 0; n < ring.peaks; n++) {
      const cell = ring.peak(k, n);
      const energy = ring.energy[cell]!;
      if (energy > 0 && view.showsPeak(ring.peakAz[cell]!, energy)) {
        frame.sparks.push({ az: ring.peakAz[cell]!, el: ring.peakEl[cell]!, energy, age: (hop - k) / Math.max(1, hop - recent) });
      }
    }
  }
  return frame;
}

/** Microphones about their centre, scaled so that the farthest stands at `reach` in the unit sphere. */
export function scaledMics(mics: { position: Vec3 }[], reach = 0.3): Vec3[] {
  if (mics.length === 0) return [];
  const centre = [0, 1, 2].map((k) => mics.reduce((sum, mic) => sum + mic.position[k]!, 0) / mics.length);
  const away = mics.map((mic) => mic.position.map((value, k) => value - centre[k]!) as Vec3);
  const farthest = Math.max(...away.map((v) => Math.hypot(...v)));
  const scale = farthest > 0 ? reach / farthest : 0;
  return away.map((v) => v.map((value) => value * scale) as Vec3);
}

export { direction };
