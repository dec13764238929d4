// SPDX-License-Identifier: MIT
// Draws when something has changed and the browser is ready: never more often, and not at all in a hidden tab.
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { counters } from "../shell/counters";

/**
 * Calls `draw` before the next frame after any signal that `watch` reads has changed. A drawing that took long waits at least as long
 * again, so that the page stays quick on a slow machine.
 */
export function usePainter(watch: () => void, draw: () => void): void {
  const latest = useRef({ watch, draw });
  latest.current = { watch, draw };
  useEffect(() => {
    let frame = 0;
    let ready = 0;
    const paint = () => {
      frame = 0;
      const begin = performance.now();
      if (begin < ready) return ask();
      latest.current.draw();
      counters.paints++;
      const end = performance.now();
      ready = end - begin > 8 ? end + 2 * (end - begin) : 0;
    };
    const ask = () => {
      if (frame === 0) frame = requestAnimationFrame(paint);
    };
    const stop = effect(() => {
      latest.current.watch();
      ask();
    });
    return () => {
      stop();
      cancelAnimationFrame(frame);
    };
  }, []);
}
