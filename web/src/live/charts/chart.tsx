// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";

import { shownTheme } from "../../shell/theme";
import { angle, angleUnit } from "../../shell/units";
import { wrap } from "../../store/angles";
import { useFitted } from "../fitted";
import { usePainter } from "../painter";
import { t } from "../texts";
import { useView, type View } from "../view";
import { drawChart, kAxes, kMargin, plotOf, type Axis } from "./draw";

/** Azimuth or elevation over time. Drag scrolls, Ctrl and the wheel zoom, the pointer reads out. */
export function Chart({ kind }: { kind: "az" | "el" }) {
  const view = useView();
  const axis = kAxes[kind];
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = useFitted(canvas);
  const drag = useRef<{ x: number; right: number } | null>(null);

  usePainter(
    () => watchAll(view, () => size.current.changed.value),
    () => {
      const draw = canvas.current?.getContext("2d");
      if (!draw || size.current.width === 0) return;
      draw.setTransform(size.current.ratio, 0, 0, size.current.ratio, 0, 0);
      drawChart(draw, view, axis, size.current.width, size.current.height);
    },
  );

  const plot = () => plotOf(view, axis, size.current.width, size.current.height);
  const move = (event: PointerEvent) => {
    const moved = drag.current ? event.clientX - drag.current.x : 0;
    if (drag.current && Math.abs(moved) > 3) {
      const inner = Math.max(1, size.current.width - kMargin.left - kMargin.right);
      view.scroll(drag.current.right - (moved * view.span.value) / inner - view.right);
    }
    const box = canvas.current!.getBoundingClientRect();
    const time = plot().time(event.clientX - box.left);
    view.cursor.value = time <= view.right && time >= view.right - view.span.value ? time : null;
    view.hovered.value = nearest(view, axis, plot(), time, event.clientY - box.top);
  };
  const wheel = (event: WheelEvent) => {
    if (!event.ctrlKey && Math.abs(event.deltaX) <= Math.abs(event.deltaY)) return;
    event.preventDefault();
    if (event.ctrlKey) view.zoom(Math.sign(event.deltaY));
    else view.scroll((event.deltaX * view.span.value) / Math.max(1, size.current.width));
  };

  return (
    <div class="chart">
      <canvas
        ref={canvas}
        role="img"
        aria-label={t(kind === "az" ? "azimuthChart" : "elevationChart", { n: view.span.value })}
        data-chart={kind}
        onPointerDown={(event) => {
          drag.current = { x: event.clientX, right: view.right };
          event.currentTarget.setPointerCapture(event.pointerId);
        }}
        onPointerUp={() => {
          drag.current = null;
          if (view.hovered.value !== null) view.selected.value = view.hovered.value;
        }}
        onPointerCancel={() => { drag.current = null; }}
        onPointerMove={move}
        onPointerLeave={() => {
          view.cursor.value = null;
          view.hovered.value = null;
        }}
        onWheel={wheel}
      />
      <span class="chart-title">{t(kind === "az" ? "azimuth" : "elevation")}</span>
      {kind === "az" && <Readout view={view} left={() => plot().x(view.cursor.value ?? 0)} />}
    </div>
  );
}

/** Every signal after which a picture of the hops is another one. */
export function watchAll(view: View, also: () => unknown = () => 0): void {
  void [view.store.beat.value, view.held.value, view.span.value, view.cursor.value, view.hovered.value, view.selected.value];
  void [view.hidden.value, view.solo.value, view.filters.value, shownTheme.value, angleUnit.value, view.store.targets.value];
  also();
}

/** The voice whose line is within 14 pixels of the pointer. */
function nearest(view: View, axis: Axis, plot: { y: (degrees: number) => number }, time: number, py: number): number | null {
  const ring = view.store.ring;
  const hop = ring.at(time);
  if (hop >= ring.end) return null;
  let best: number | null = null;
  let least = 14;
  for (let slot = 0; slot < ring.slots; slot++) {
    const cell = ring.cell(hop, slot);
    const id = ring.id[cell]!;
    if (id === 0 || !view.showsVoice(id, ring.az[cell]!, ring.activity[cell]!)) continue;
    const away = Math.abs(plot.y(axis.kind === "az" ? wrap(ring.az[cell]!) : ring.el[cell]!) - py);
    if (away < least) {
      least = away;
      best = id;
    }
  }
  return best;
}

/** Where every voice was at the cursor. */
function Readout({ view, left }: { view: View; left: () => number }) {
  const time = view.cursor.value;
  if (time === null) return null;
  void view.pulse.value;
  const ring = view.store.ring;
  const hop = ring.at(time);
  const rows: string[] = [];
  for (let slot = 0; hop < ring.end && slot < ring.slots; slot++) {
    const cell = ring.cell(hop, slot);
    if (ring.id[cell]! !== 0 && view.shows(ring.id[cell]!)) rows.push(`#${ring.id[cell]!}  ${angle(ring.az[cell]!)} / ${angle(ring.el[cell]!)}`);
  }
  const x = left();
  return (
    <div class="readout" style={x > 220 ? { right: `calc(100% - ${x - 8}px)` } : { left: `${x + 8}px` }}>
      <b>{`${time.toFixed(2)} s`}</b>
      {rows.map((row) => <span key={row}>{row}</span>)}
    </div>
  );
}
