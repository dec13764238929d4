// SPDX-License-Identifier: MIT
// How loud a recording is over its time; the place that plays, and where to go on from.
import { useEffect, useRef, useState } from "preact/hooks";

import { clock } from "../../lib/bytes";
import type { Recording } from "../../lib/recording_list";
import { useStudio } from "../../studio";
import { Canvas, type Pen } from "../shared/canvas";
import type { Player } from "./player";
import { t } from "./texts";

interface Peaks {
  min: number[];
  max: number[];
  seconds?: number;
}

const kColumns = 400;
const known = new Map<string, Peaks>();

/** Asked for when the row comes into sight, once for each recording. */
function usePeaks(name: string) {
  const { call } = useStudio();
  const place = useRef<HTMLDivElement>(null);
  const [peaks, setPeaks] = useState<Peaks | null>(known.get(name) ?? null);
  useEffect(() => {
    if (known.has(name)) return setPeaks(known.get(name)!);
    const observer = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      call<Peaks>("recordings.peaks", { name, columns: kColumns }).then((found) => {
        if (!Array.isArray(found?.max) || !Array.isArray(found?.min)) return;
        known.set(name, found);
        setPeaks(found);
      }, () => {});
    });
    observer.observe(place.current!);
    return () => observer.disconnect();
  }, [name]);
  return { place, peaks };
}

export function Waveform({ recording, player }: { recording: Recording; player: Player }) {
  const { name } = recording;
  const { place, peaks } = usePeaks(name);
  const seconds = recording.seconds ?? peaks?.seconds ?? 0;
  const mine = player.name.value === name;
  const at = mine ? player.seconds.value : 0;
  const seek = (to: number) => player.seek(name, Math.min(Math.max(to, 0), seconds));
  const point = (event: PointerEvent) => {
    if (event.type === "pointermove" && event.buttons !== 1) return;
    const box = place.current!.getBoundingClientRect();
    seek(((event.clientX - box.left) / box.width) * seconds);
  };
  const press = (event: KeyboardEvent) => {
    const to = { ArrowLeft: at - 1, ArrowRight: at + 1, PageDown: at - 10, PageUp: at + 10, Home: 0, End: seconds }[event.key];
    if (event.key === " " || event.key === "Enter") player.toggle(name);
    else if (to !== undefined) seek(to);
    else return;
    event.preventDefault();
  };
  return (
    <div
      ref={place}
      class="waveform"
      role="slider"
      tabIndex={0}
      data-own-keys
      aria-label={t("seek", { name: recording.label || name })}
      aria-valuemin={0}
      aria-valuemax={Math.round(seconds * 10) / 10}
      aria-valuenow={Math.round(at * 10) / 10}
      aria-valuetext={t("position", { at: clock(at), all: clock(seconds) })}
      onPointerDown={point}
      onPointerMove={point}
      onKeyDown={press}
    >
      <Canvas aria-hidden="true" draw={(pen) => drawPeaks(pen, peaks, seconds > 0 ? at / seconds : 0, mine)} when={[peaks, at, mine, seconds]} />
    </div>
  );
}

function drawPeaks({ ctx, width, height, color }: Pen, peaks: Peaks | null, played: number, mine: boolean): void {
  const middle = height / 2;
  ctx.fillStyle = color("line-strong");
  if (!peaks || peaks.max.length === 0) return ctx.fillRect(0, middle, width, 1);
  const columns = peaks.max.length;
  // Quiet recordings are drawn larger, up to 20 dB, so that they can be told from silence.
  const loudest = Math.max(0.1, ...peaks.max, ...peaks.min.map((v) => -v));
  const bars = Math.floor(width / 3);
  const before = color("accent");
  const after = color("line-strong");
  for (let bar = 0; bar < bars; ++bar) {
    const from = Math.floor((bar * columns) / bars);
    const to = Math.max(from + 1, Math.floor(((bar + 1) * columns) / bars));
    let low = 0;
    let high = 0;
    for (let i = from; i < to; ++i) {
      low = Math.min(low, peaks.min[i] ?? 0);
      high = Math.max(high, peaks.max[i] ?? 0);
    }
    ctx.fillStyle = mine && bar / bars <= played ? before : after;
    const top = middle - (high / loudest) * (middle - 1);
    const bottom = middle - (low / loudest) * (middle - 1);
    ctx.fillRect(bar * 3, top, 2, Math.max(1, bottom - top));
  }
  if (!mine) return;
  ctx.fillStyle = color("text");
  ctx.fillRect(Math.min(width - 1.5, played * width), 0, 1.5, height);
}
