// SPDX-License-Identifier: MIT
// A drawing that fits its place, sharp on every screen, in the colours of the theme.
import type { CanvasHTMLAttributes } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { shownTheme } from "../../shell/theme";

export interface Pen {
  ctx: CanvasRenderingContext2D;
  /** CSS pixels. */
  width: number;
  height: number;
  /** The value of a token: `color("accent")`. */
  color(token: string): string;
}

type Props = Omit<CanvasHTMLAttributes<HTMLCanvasElement>, "ref"> & {
  /** Drawn again whenever `when` changes, and with the size and the theme. */
  draw: (pen: Pen) => void;
  when: readonly unknown[];
};

export function Canvas({ draw, when, ...rest }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const latest = useRef(draw);
  latest.current = draw;
  const paint = () => paintOn(canvas.current, latest.current);
  useEffect(() => {
    const observer = new ResizeObserver(paint);
    observer.observe(canvas.current!);
    return () => observer.disconnect();
  }, []);
  useEffect(paint, [...when, shownTheme.value]);
  return <canvas ref={canvas} {...rest} />;
}

function paintOn(canvas: HTMLCanvasElement | null, draw: (pen: Pen) => void): void {
  const ctx = canvas?.getContext("2d");
  if (!canvas || !ctx) return;
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width === 0 || height === 0) return;
  const ratio = Math.min(globalThis.devicePixelRatio || 1, 3);
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  const style = getComputedStyle(canvas);
  draw({ ctx, width, height, color: (token) => style.getPropertyValue(`--${token}`).trim() });
}
