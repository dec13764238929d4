// SPDX-License-Identifier: MIT
// Signals that remember their value in this browser.
import { effect, signal, type Signal } from "@preact/signals";

/** `accept` turns what was stored (by any version of this page) into a value that is allowed. */
export function stored<T>(name: string, initial: T, accept: (value: unknown) => T): Signal<T> {
  const key = `odas.${name}`;
  const result = signal<T>(read(key, initial, accept));
  effect(() => write(key, result.value));
  return result;
}

function read<T>(key: string, initial: T, accept: (value: unknown) => T): T {
  try {
    const text = localStorage.getItem(key);
    return text === null ? initial : accept(JSON.parse(text));
  } catch {
    return initial;
  }
}

function write(key: string, value: unknown): void {
  try {
    localStorage.setItem(key, JSON.stringify(value));
  } catch {
    // Private windows may store nothing: then the choice lasts as long as the page.
  }
}
