// SPDX-License-Identifier: MIT
import { kDashes, type Look } from "../../store/colors";

const kShapes = {
  circle: <circle cx="17" cy="7" r="4.5" />,
  square: <rect x="13" y="3" width="8" height="8" />,
  triangle: <path d="M17 1.8l5 9.2h-10z" />,
  diamond: <path d="M17 1.2l5 5.8-5 5.8-5-5.8z" />,
} as const;

/** Line, dash and marker of a voice, as the charts draw it. */
export function Swatch({ look }: { look: Look }) {
  return (
    <svg class="swatch" viewBox="0 0 34 14" aria-hidden="true" fill="currentColor" stroke="currentColor">
      <line x1="0" y1="7" x2="34" y2="7" stroke-width="2.5" stroke-dasharray={kDashes[look.dash]!.join(" ")} />
      {kShapes[look.marker]}
    </svg>
  );
}
