// SPDX-License-Identifier: MIT
// Sphere (or flat map): drawing, pointing, choosing.
import { effect } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";

import { probe } from "../../shell/counters";
import { Icon } from "../../shell/icons";
import { reducedMotion, shownTheme } from "../../shell/theme";
import type { Vec3 } from "../../socket/messages";
import type { Store } from "../../store/store";
import { useStudio } from "../../studio";
import { watchAll } from "../charts/chart";
import { useFitted } from "../fitted";
import { usePainter } from "../painter";
import { t } from "../texts";
import { useView, type Preset } from "../view";
import { FlatMap } from "./flat";
import { direction, frameOf, scaledMics, type Frame } from "./frame";
import { drawOverlay } from "./overlay";
import { PinPopover } from "./pin";
import type { Stage } from "./stage";
import { SphereSummary } from "./summary";

const kViews: Preset[] = ["front", "top", "side", "iso"];

/** Milliseconds that the sphere waits for a first hop. */
const kPatience = 1000;

/** Making the sphere keeps a slow computer busy for a moment: whoever is there is seen before. At once where nothing runs. */
function firstHopShown(store: Store): Promise<void> {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, kPatience);
    const stop = effect(() => {
      const idle = store.link.value === "still" || store.link.value === "offline";
      if (!idle && (store.beat.value === 0 || store.ring.end === 0)) return;
      clearTimeout(timer);
      queueMicrotask(() => stop());
      requestAnimationFrame(() => whenIdle(resolve));
    });
  });
}

/** Once nothing else is to be done, and half a second later at most; some browsers cannot tell. */
function whenIdle(act: () => void): void {
  if ("requestIdleCallback" in globalThis) requestIdleCallback(act, { timeout: 500 });
  else setTimeout(act, 100);
}

/** Rejects where there is no WebGL 2. A canvas that has been asked for it gives no 2-D any more: the flat map takes another one. */
async function makeStage(canvas: HTMLCanvasElement, onMove: () => void): Promise<Stage> {
  const context = canvas.getContext("webgl2", { alpha: false, antialias: true, powerPreference: "low-power" });
  if (!context) throw new Error("no WebGL");
  const { SphereScene } = await import("./scene");
  const scene = new SphereScene(canvas, context, onMove);
  await scene.compiled();
  return scene;
}

export function SpherePanel() {
  const view = useView();
  const { store, setPower } = useStudio();
  const flat = useRef<HTMLCanvasElement>(null);
  const deep = useRef<HTMLCanvasElement>(null);
  const over = useRef<HTMLCanvasElement>(null);
  const size = useFitted(over);
  const stage = useRef<Stage | null>(null);
  const theme = useRef("");
  const asked = useRef(-1);
  const frame = useRef<Frame>({ balls: [], sparks: [] });
  const [kind, setKind] = useState<"loading" | "deep" | "flat">("loading");
  const [pin, setPin] = useState<{ x: number; y: number; at: Vec3 } | null>(null);
  const pressed = useRef<{ x: number; y: number } | null>(null);

  useEffect(() => {
    let gone = false;
    const make = async () => {
      await firstHopShown(store);
      if (gone) return;
      const scene = await makeStage(deep.current!, () => size.current.changed.value++).catch(() => null);
      if (gone) return scene?.dispose();
      stage.current = scene ?? new FlatMap(flat.current!);
      setKind(scene ? "deep" : "flat");
      size.current.changed.value++;
    };
    void make();
    return () => {
      gone = true;
      stage.current?.dispose();
      stage.current = null;
    };
  }, []);
  useEffect(() => {
    setPower(view.heat.value ? 5 : 0);
    return () => setPower(0);
  }, [view.heat.value]);

  usePainter(
    () => watchAll(view, () => [size.current.changed.value, view.preset.value, view.follow.value, view.mic.value, view.heat.value, store.power.value, store.run.value]),
    () => {
      const now = stage.current;
      const { width, height, ratio } = size.current;
      const draw = over.current?.getContext("2d");
      if (!now || !draw || width === 0) return;
      const fitted = `${width} ${height} ${ratio}`;
      if (over.current!.dataset.fitted !== fitted) {
        over.current!.dataset.fitted = fitted;
        now.resize(width, height, ratio);
      }
      if (theme.current !== shownTheme.value) {
        theme.current = shownTheme.value;
        now.recolor();
      }
      if (asked.current !== view.preset.value.asked) {
        asked.current = view.preset.value.asked;
        now.look(view.preset.value.name);
      }
      frame.current = frameOf(view);
      const followed = view.follow.value ? (frame.current.balls.find((ball) => ball.id === view.selected.value) ?? frame.current.balls[0]) : undefined;
      if (followed) now.follow(followed.az, followed.el, reducedMotion.value ? 1 : 0.12);
      const mics = scaledMics(store.run.value?.mics ?? []);
      const pointed = view.hovered.value ?? view.selected.value;
      const power = view.heat.value ? store.power.value : null;
      now.draw(frame.current, { pointed, energy: view.filters.value.energy, mics, mic: view.mic.value, power, powerGrid: store.run.value?.power_grid ?? [] });
      draw.setTransform(ratio, 0, 0, ratio, 0, 0);
      drawOverlay(draw, width, height, now, frame.current, { flat: kind === "flat", mics, mic: view.mic.value, pointed, targets: store.targets.value });
    },
  );

  probe("sphere", () => ({
    kind,
    calls: stage.current?.calls ?? 0,
    mics: store.run.value?.mics?.length ?? 0,
    balls: frame.current.balls.map((ball) => ({ id: ball.id, ...stage.current!.project(direction(ball.az, ball.el)) })),
    centre: stage.current?.project(direction(0, 0)),
  }));

  const place = (event: PointerEvent) => {
    const box = over.current!.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const ballAt = (x: number, y: number) => nearest(frame.current.balls.map((ball) => ({ id: ball.id, at: direction(ball.az, ball.el) })), stage.current, x, y, 18);
  const hover = (event: PointerEvent) => {
    const { x, y } = place(event);
    view.hovered.value = ballAt(x, y);
  };
  const release = (event: PointerEvent) => {
    const at = place(event);
    const from = pressed.current;
    pressed.current = null;
    if (!stage.current || !from || Math.hypot(at.x - from.x, at.y - from.y) > 5) return;
    const id = ballAt(at.x, at.y);
    if (id !== null) return void (view.selected.value = id);
    const mics = kind === "deep" ? scaledMics(store.run.value?.mics ?? []) : [];
    const mic = nearest(mics.map((where, k) => ({ id: k, at: where })), stage.current, at.x, at.y, 10);
    if (mic !== null) return void (view.mic.value = view.mic.value === mic ? null : mic);
    const where = stage.current.pick(at.x, at.y);
    setPin(where && store.can("targets") && store.operator.value ? { ...at, at: where } : null);
  };
  const pointer = {
    onPointerDown: (event: PointerEvent) => {
      pressed.current = place(event);
      setPin(null);
    },
    onPointerMove: hover,
    onPointerUp: release,
    onPointerLeave: () => { view.hovered.value = null; },
  };

  return (
    <section class="panel sphere" aria-label={t("sphere")}>
      <header>
        <h2>{t("sphere")}</h2>
        {kind !== "flat" && (
          <div class="segments" role="group" aria-label={t("views")}>
            {kViews.map((name, k) => (
              <button key={name} class="segment" aria-pressed={view.preset.value.name === name} title={`${t(`view_${name}`)} (${k + 1})`} onClick={() => view.look(name)}>{t(`view_${name}`)}</button>
            ))}
          </div>
        )}
        {kind !== "flat" && (
          <button class="button ghost icon-only" aria-pressed={view.follow.value} aria-label={t("follow")} title={`${t("follow")} (F)`} onClick={() => { view.follow.value = !view.follow.value; }}><Icon name="follow" /></button>
        )}
        {store.can("power") && (
          <button class="button ghost icon-only" aria-pressed={view.heat.value} aria-label={t("heat")} title={t("heat")} onClick={() => { view.heat.value = !view.heat.value; }}><Icon name="heat" /></button>
        )}
      </header>
      <div class="sphere-box" data-stage={kind}>
        <canvas ref={deep} class="layer" aria-hidden="true" hidden={kind === "flat"} {...pointer} />
        <canvas ref={flat} class="layer" aria-hidden="true" hidden={kind !== "flat"} {...pointer} />
        <canvas ref={over} class="layer over" aria-hidden="true" />
        <SphereSummary />
        {kind === "flat" && <p class="sphere-note">{t("noWebgl")}</p>}
        {pin && <PinPopover {...pin} close={() => setPin(null)} />}
      </div>
    </section>
  );
}

function nearest(points: { id: number; at: Vec3 }[], stage: Stage | null, x: number, y: number, within: number): number | null {
  let best: number | null = null;
  let least = within;
  for (const { id, at } of points) {
    const projected = stage?.project(at);
    if (!projected) continue;
    const away = Math.hypot(projected.x - x, projected.y - y) + (projected.front ? 0 : 4);
    if (away < least) {
      least = away;
      best = id;
    }
  }
  return best;
}
