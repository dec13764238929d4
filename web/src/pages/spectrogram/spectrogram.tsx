// SPDX-License-Identifier: MIT
// The sound of one voice over frequency and time, beside what the microphone or the post-filter makes of it.
import { signal, type Signal } from "@preact/signals";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { heatTable } from "../../lib/heat";
import type { AudioBlock } from "../../socket/binary";
import type { AudioWish, StreamName } from "../../socket/messages";
import { Canvas, type Pen } from "../shared/canvas";
import { byteOf, Roll } from "./roll";
import { t } from "./texts";

type Side = StreamName | "none";

interface Props {
  /** The selected voice; null: none. */
  track: number | null;
  /** Microphones that there are. */
  mics: number;
  /** Says which sound is needed; called with [] when none is any more. */
  onWish: (wishes: AudioWish[]) => void;
  /** Gives every block of sound that arrives to `take`, until the returned function is called. */
  listen: (take: (block: AudioBlock) => void) => () => void;
}

const kColumns = 400;

function wishOf(side: Side, track: number, mic: number): AudioWish[] {
  if (side === "none") return [];
  return [side === "raw" ? { stream: side, mic } : { stream: side, track }];
}

function isOf(block: AudioBlock, side: Side, track: number, mic: number): boolean {
  return block.stream === side && block.source === (side === "raw" ? mic : track);
}

export function Spectrogram({ track, mics, onWish, listen }: Props) {
  const [above, setAbove] = useState<Side>("separated");
  const [below, setBelow] = useState<Side>("raw");
  const [mic, setMic] = useState(1);
  const [floor, setFloor] = useState(-90);
  const rolls = useMemo(() => [new Roll(kColumns), new Roll(kColumns)] as const, []);
  const beat = useMemo(() => signal(0), []);
  useEffect(() => {
    for (const roll of rolls) roll.clear();
    beat.value++;
    if (track === null) return;
    onWish([...wishOf(above, track, mic), ...wishOf(below, track, mic)].filter((wish, i, all) => all.findIndex((other) => other.stream === wish.stream) === i));
    let frame = 0;
    const stop = listen((block) => {
      [above, below].forEach((side, i) => {
        if (isOf(block, side, track, mic)) rolls[i]!.push(block);
      });
      frame ||= requestAnimationFrame(() => {
        frame = 0;
        beat.value++;
      });
    });
    return () => {
      stop();
      cancelAnimationFrame(frame);
      onWish([]);
    };
  }, [track, above, below, mic]);
  return (
    <section class="panel spectrogram" aria-labelledby="spectrogram-title">
      <header>
        <h2 id="spectrogram-title">{t("title")}</h2>
        <SideSelect label={t("left")} value={above} onChange={setAbove} />
        <SideSelect label={t("right")} value={below} onChange={setBelow} />
        {(above === "raw" || below === "raw") && mics > 1 && (
          <span class="inline-field">
            <select value={String(mic)} aria-label={t("mic")} onChange={(event) => setMic(Number(event.currentTarget.value))}>
              {Array.from({ length: mics }, (_, i) => <option key={i} value={String(i + 1)}>{t("raw", { n: i + 1 })}</option>)}
            </select>
          </span>
        )}
        <label class="inline-field">
          <span>{t("floor")}</span>
          <select value={String(floor)} onChange={(event) => setFloor(Number(event.currentTarget.value))}>
            {[-60, -75, -90, -105].map((db) => <option key={db} value={String(db)}>{t("dB", { n: number(db) })}</option>)}
          </select>
        </label>
      </header>
      {track === null ? (
        <div class="empty"><h3>{t("choose")}</h3><p>{t("chooseNext")}</p></div>
      ) : (
        [above, below].map((side, i) => side !== "none" && (
          <figure key={i} class="spectrogram-picture">
            <figcaption class="small-text soft">{side === "raw" ? t("raw", { n: mic }) : t(side)}</figcaption>
            <Picture roll={rolls[i]!} beat={beat} floor={floor} name={side === "raw" ? t("raw", { n: mic }) : t(side)} />
          </figure>
        ))
      )}
    </section>
  );
}

function SideSelect({ label, value, onChange }: { label: string; value: Side; onChange: (side: Side) => void }) {
  return (
    <label class="inline-field">
      <span>{label}</span>
      <select value={value} onChange={(event) => onChange(event.currentTarget.value as Side)}>
        <option value="separated">{t("separated")}</option>
        <option value="postfiltered">{t("postfiltered")}</option>
        <option value="raw">{t("mic")}</option>
        <option value="none">{t("none")}</option>
      </select>
    </label>
  );
}

function Picture({ roll, beat, floor, name }: { roll: Roll; beat: Signal<number>; floor: number; name: string }) {
  const image = useRef<{ canvas: HTMLCanvasElement; data: ImageData } | null>(null);
  const { bin, level } = roll.loudest;
  const loud = level > floor && roll.written > 0 ? t("loudest", { hz: number((bin * roll.rate) / (2 * (roll.bins - 1))), db: number(level) }) : t("silent");
  const label = `${t("label", { what: name, hz: roll.rate / 2, s: number(roll.seconds, 1) })}; ${loud}`;
  return <Canvas role="img" aria-label={label} data-written={roll.written} data-loudest={bin} draw={(pen) => draw(pen, roll, floor, image)} when={[beat.value, floor]} />;
}

const table = heatTable();

function draw({ ctx, width, height, color }: Pen, roll: Roll, floor: number, image: { current: { canvas: HTMLCanvasElement; data: ImageData } | null }): void {
  if (!image.current) {
    const canvas = document.createElement("canvas");
    canvas.width = roll.columns;
    canvas.height = roll.bins;
    image.current = { canvas, data: new ImageData(roll.columns, roll.bins) };
  }
  const { canvas, data } = image.current;
  const low = byteOf(floor);
  const scale = 255 / (byteOf(-10) - low);
  for (let column = 0; column < roll.columns; ++column) {
    const from = roll.written - roll.columns + column;
    for (let bin = 0; bin < roll.bins; ++bin) {
      const level = from < 0 ? 0 : roll.levels[(from % roll.columns) * roll.bins + bin]!;
      const shade = 4 * Math.round(Math.min(255, Math.max(0, (level - low) * scale)));
      const at = 4 * ((roll.bins - 1 - bin) * roll.columns + column);
      for (let c = 0; c < 4; ++c) data.data[at + c] = table[shade + c]!;
    }
  }
  canvas.getContext("2d")!.putImageData(data, 0, 0);
  const left = 44;
  ctx.imageSmoothingEnabled = true;
  ctx.drawImage(canvas, left, 0, width - left, height);
  ctx.fillStyle = color("plot-text");
  ctx.font = `11px ${getComputedStyle(document.body).fontFamily}`;
  ctx.textAlign = "right";
  const top = roll.rate / 2000;
  for (let share = 0; share <= 1; share += 0.25) {
    ctx.textBaseline = share === 0 ? "bottom" : share === 1 ? "top" : "middle";
    ctx.fillText(t("kHz", { n: number(top * share, top < 8 ? 1 : 0) }), left - 6, height * (1 - share));
  }
}
