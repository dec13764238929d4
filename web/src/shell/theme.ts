// SPDX-License-Identifier: MIT
// Light, dark, high contrast, or as the system says.
import { computed, effect, signal } from "@preact/signals";

import { stored } from "./stored";

export type Theme = "system" | "light" | "dark" | "contrast";

export const kThemes: Theme[] = ["system", "light", "dark", "contrast"];

export const theme = stored<Theme>("theme", "system", (value) =>
  kThemes.includes(value as Theme) ? (value as Theme) : "system",
);

function media(query: string) {
  const list = matchMedia(query);
  const result = signal(list.matches);
  list.addEventListener("change", (event) => {
    result.value = event.matches;
  });
  return result;
}

const systemDark = media("(prefers-color-scheme: dark)");
const systemContrast = media("(prefers-contrast: more)");

export const reducedMotion = media("(prefers-reduced-motion: reduce)");

/** What is shown: high contrast is black and is drawn with the colours of dark. */
export const shownTheme = computed<"light" | "dark" | "contrast">(() => {
  if (theme.value !== "system") return theme.value;
  if (systemContrast.value) return "contrast";
  return systemDark.value ? "dark" : "light";
});

export function nextTheme(): void {
  theme.value = kThemes[(kThemes.indexOf(theme.value) + 1) % kThemes.length]!;
}

export function followTheme(): void {
  effect(() => {
    document.documentElement.dataset.theme = shownTheme.value;
  });
}
