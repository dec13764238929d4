// SPDX-License-Identifier: MIT
// Short words at the edge of the page, for what a command did or why it did not.
import { signal } from "@preact/signals";

import { CommandError } from "../rpc";
import { t } from "./texts";

interface Toast {
  id: number;
  text: string;
  kind: "info" | "error";
}

const toasts = signal<Toast[]>([]);
let next = 1;

export function say(text: string, kind: Toast["kind"] = "info"): void {
  const id = next++;
  toasts.value = [...toasts.value.slice(-3), { id, text, kind }];
  setTimeout(() => {
    toasts.value = toasts.value.filter((toast) => toast.id !== id);
  }, kind === "error" ? 10000 : 4000);
}

/** Says why a command failed; for `call(...).catch(sayError)`. */
export function sayError(error: unknown): void {
  say(t("commandFailed", { why: error instanceof CommandError ? error.message : String(error) }), "error");
}

export function Toasts() {
  return (
    <div class="toasts" role="status">
      {toasts.value.map((toast) => (
        <div key={toast.id} class={`toast ${toast.kind}`}>{toast.text}</div>
      ))}
    </div>
  );
}
