// SPDX-License-Identifier: MIT
// Texts in English and French. Every folder keeps its own: `const t = texts({ en: {...}, fr: {...} })`, then `t("key")`.
import { computed, signal } from "@preact/signals";

import { stored } from "../shell/stored";

export type Language = "en" | "fr";

const kLanguages: Language[] = ["en", "fr"];

/** What the user has chosen; `null`: as the browser says. */
export const chosenLanguage = stored<Language | null>("language", null, (value) =>
  kLanguages.includes(value as Language) ? (value as Language) : null,
);

const browserLanguage = signal<Language>(
  globalThis.navigator?.language?.toLowerCase().startsWith("fr") ? "fr" : "en",
);

export const language = computed<Language>(() => chosenLanguage.value ?? browserLanguage.value);

export type Values = Record<string, string | number>;

/** The text of `key` in the language of now (a component that calls it is drawn again when that changes); `{name}` takes `values.name`. */
export type Translate<Key extends string> = (key: Key, values?: Values) => string;

export function texts<Key extends string>(tables: { en: Record<Key, string>; fr: Record<NoInfer<Key>, string> }): Translate<Key> {
  return (key, values) => fill(tables[language.value][key], values);
}

function fill(text: string, values: Values | undefined): string {
  return values ? text.replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole)) : text;
}

/** A number as the language of now writes it, with the minus of print. */
export function number(value: number, digits = 0): string {
  return value.toLocaleString(language.value, { minimumFractionDigits: digits, maximumFractionDigits: digits }).replace("-", "\u2212");
}
