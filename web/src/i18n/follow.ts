// SPDX-License-Identifier: MIT
import { effect } from "@preact/signals";

import { language } from "./i18n";

/** Tells the document its language, for screen readers and hyphens. */
export function followLanguage(): void {
  effect(() => {
    document.documentElement.lang = language.value;
  });
}
