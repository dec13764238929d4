// SPDX-License-Identifier: MIT
// The whole session at a glance: who was there when, where we are, and the loop.
import { useMemo, useRef } from "preact/hooks";

import { clock } from "../../lib/bytes";
import { lanes } from "../../lib/lanes";
import type { Session } from "../../lib/session";
import { Canvas, type Pen } from "../shared/canvas";
import type { Playback } from "./playback";
import { t } from "./texts";

export function Timeline({ playback, session }: { playback: Playback; session: Session }) {
  const place = useRef<HTMLDivElement>(null);
  const rows = useMemo(() => lanes(session.spans, 6), [session]);
  const at = playback.position.value;
  const loop = playback.looping.value ? playback.loop.value : null;
  const point = (event: PointerEvent) => {
    if (event.type === "pointermove" && event.buttons !== 1) return;
    if (event.type === "pointerdown") place.current!.setPointerCapture(event.pointerId);
    const box = place.current!.getBoundingClientRect();
    playback.seek(((event.clientX - box.left) / box.width) * session.seconds);
  };
  const press = (event: KeyboardEvent) => {
    const to = { ArrowLeft: at - 1, ArrowRight: at + 1, PageDown: at - 10, PageUp: at + 10, Home: 0, End: session.seconds }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    playback.seek(to);
  };
  return (
    <div
      ref={place} class="timeline" role="slider" tabIndex={0} aria-label={t("position")}
      aria-valuemin={0} aria-valuemax={Math.round(session.seconds * 10) / 10} aria-valuenow={Math.round(at * 10) / 10}
      aria-valuetext={t("positionOf", { at: clock(at, true), all: clock(session.seconds, true) })}
      onPointerDown={point} onPointerMove={point} onKeyDown={press}
    >
      <Canvas aria-hidden="true" draw={(pen) => drawTimeline(pen, session, rows, at, loop)} when={[session, at, loop]} />
    </div>
  );
}

type Rows = ReturnType<typeof lanes<Session["spans"][number]>>;

function drawTimeline({ ctx, width, height, color }: Pen, session: Session, rows: Rows, at: number, loop: { a: number; b: number } | null): void {
  const all = session.seconds || 1;
  const x = (seconds: number) => (seconds / all) * width;
  if (loop) {
    ctx.fillStyle = color("accent-soft");
    ctx.fillRect(x(loop.a), 0, x(loop.b) - x(loop.a), height);
  }
  drawScale(ctx, all, width, height, color("plot-text"), color("plot-grid"));
  const top = 16;
  const step = Math.min(16, (height - top - 2) / Math.max(1, rows.length));
  ctx.font = `500 ${Math.min(11, step - 3)}px ${getComputedStyle(document.body).fontFamily}`;
  ctx.textBaseline = "middle";
  rows.forEach((row, i) => {
    for (const span of row) {
      const left = x(span.from);
      const length = Math.max(2, x(span.to) - left);
      ctx.fillStyle = span.kind === 2 ? color("accent") : color("line-strong");
      ctx.beginPath();
      ctx.roundRect(left, top + i * step, length, step - 3, 3);
      ctx.fill();
      ctx.fillStyle = span.kind === 2 ? color("on-accent") : color("surface");
      if (length > 28 && step > 9) ctx.fillText(span.tag ?? String(span.id), left + 5, top + i * step + (step - 3) / 2 + 0.5, length - 8);
    }
  });
  ctx.fillStyle = color("text");
  ctx.fillRect(Math.min(width - 2, Math.max(0, x(at) - 1)), 0, 2, height);
}

function drawScale(ctx: CanvasRenderingContext2D, all: number, width: number, height: number, text: string, grid: string): void {
  const wish = (all / width) * 90;
  const step = [0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600].find((one) => one >= wish) ?? 7200;
  ctx.font = `11px ${getComputedStyle(document.body).fontFamily}`;
  ctx.textBaseline = "top";
  for (let seconds = 0; seconds < all; seconds += step) {
    const x = Math.round((seconds / all) * width) + 0.5;
    ctx.fillStyle = grid;
    ctx.fillRect(x, 0, 1, height);
    ctx.fillStyle = text;
    if (x < width - 30) ctx.fillText(clock(seconds, step < 1), x + 4, 2);
  }
}
