// SPDX-License-Identifier: MIT
// Draws when something has changed and the browser is ready: never more often, and not at all in a hidden tab.
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { counters } from "../shell/counters";

/** Milliseconds: a frame that comes later than this after it was asked for says that the computer is busy. */
const kLate = 50;
const kLongestRest = 500;

/**
 * Calls `draw` before the next frame after any signal that `watch` reads has changed. After a drawing that took long, or a frame that
 * came late, it rests at least as long again, so that the page stays quick on a slow machine.
 */
export function usePainter(watch: () => void, draw: () => void): void {
  const latest = useRef({ watch, draw });
  latest.current = { watch, draw };
  useEffect(() => {
    let frame = 0;
    let timer: ReturnType<typeof setTimeout> | undefined;
    let asked = 0;
    let ready = 0;
    const paint = () => {
      frame = 0;
      const begin = performance.now();
      latest.current.draw();
      counters.paints++;
      const end = performance.now();
      const drawing = end - begin > 8 ? 2 * (end - begin) : 0;
      const late = begin - asked > kLate ? begin - asked : 0;
      ready = end + Math.min(kLongestRest, Math.max(drawing, late));
    };
    const ask = () => {
      timer = undefined;
      asked = performance.now();
      frame = requestAnimationFrame(paint);
    };
    const stop = effect(() => {
      latest.current.watch();
      if (frame !== 0 || timer !== undefined) return;
      const rest = ready - performance.now();
      if (rest > 0) timer = setTimeout(ask, rest);
      else ask();
    });
    return () => {
      stop();
      clearTimeout(timer);
      cancelAnimationFrame(frame);
    };
  }, []);
}
