// SPDX-License-Identifier: MIT
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

/** A button that opens a small panel below it; Escape and a click elsewhere close it, and so does a choice. */
export function Menu({ label, face, class: name = "", children }: { label: string; face: ComponentChildren; class?: string; children: ComponentChildren }) {
  const details = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const close = (event: Event) => {
      const element = details.current;
      if (element?.open && !element.contains(event.target as Node)) element.open = false;
    };
    addEventListener("pointerdown", close);
    return () => removeEventListener("pointerdown", close);
  }, []);
  const escape = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || !details.current?.open) return;
    details.current.open = false;
    details.current.querySelector("summary")?.focus();
  };
  const choose = (event: Event) => {
    if (!(event.target as HTMLElement).closest(".menu-item") || !details.current) return;
    details.current.open = false;
    details.current.querySelector("summary")?.focus();
  };
  return (
    <details ref={details} class={`menu ${name}`} onKeyDown={escape}>
      <summary class="button ghost" aria-label={label} title={label}>{face}</summary>
      <div class="menu-panel" onClick={choose}>{children}</div>
    </details>
  );
}
