// SPDX-License-Identifier: MIT
import { signal, type Signal } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";

export interface Fitted {
  /** CSS pixels. */
  width: number;
  height: number;
  /** Pixels of the canvas for one of CSS. */
  ratio: number;
  changed: Signal<number>;
}

/** Keeps a canvas as large as its box, in pixels of the screen. */
export function useFitted(canvas: RefObject<HTMLCanvasElement | null>): { readonly current: Fitted } {
  const size = useRef<Fitted>({ width: 0, height: 0, ratio: 1, changed: signal(0) });
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const fit = () => {
      const now = size.current;
      now.width = element.clientWidth;
      now.height = element.clientHeight;
      now.ratio = Math.min(2, devicePixelRatio || 1);
      element.width = Math.max(1, Math.round(now.width * now.ratio));
      element.height = Math.max(1, Math.round(now.height * now.ratio));
      now.changed.value++;
    };
    const observer = new ResizeObserver(fit);
    observer.observe(element);
    fit();
    return () => observer.disconnect();
  }, []);
  return size;
}
