// SPDX-License-Identifier: MIT
// Keys of the page. A component binds its own while it is shown; the help overlay lists those that are bound.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";

export interface Binding {
  /** `KeyboardEvent.key`, lower case for letters. */
  keys: string[];
  /** What the help shows for the keys. */
  label: string;
  meaning: () => string;
  group: () => string;
  run: (event: KeyboardEvent) => void;
}

export const bindings = signal<Binding[]>([]);

/** Binds keys while the component is shown. `make` must give the same keys for the whole time. */
export function useKeys(make: () => Binding[]): void {
  useEffect(() => {
    const mine = make();
    bindings.value = [...bindings.value, ...mine];
    return () => {
      bindings.value = bindings.value.filter((binding) => !mine.includes(binding));
    };
  }, []);
}

/** Keys belong to the field, button or menu that has the focus first. */
function taken(event: KeyboardEvent): boolean {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return true;
  const target = event.target as HTMLElement | null;
  if (!target?.closest) return false;
  if (target.closest("input, select, textarea, dialog, [contenteditable], [data-own-keys]")) {
    const toggle = target instanceof HTMLInputElement && ["checkbox", "radio", "button"].includes(target.type);
    return !(toggle && event.key !== " " && !event.key.startsWith("Arrow"));
  }
  return target.closest("button, a, summary") !== null && (event.key === " " || event.key === "Enter");
}

export function followKeys(): () => void {
  const press = (event: KeyboardEvent) => {
    if (taken(event)) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const binding = bindings.value.findLast((one) => one.keys.includes(key));
    if (!binding) return;
    event.preventDefault();
    binding.run(event);
  };
  addEventListener("keydown", press);
  return () => removeEventListener("keydown", press);
}
