// SPDX-License-Identifier: MIT
import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { bindings, type Binding } from "./keys";
import { Icon } from "./icons";
import { t } from "./texts";

const open = signal(false);

export function toggleHelp(): void {
  open.value = !open.value;
}

/** All keys that work on this page. A modal dialog: the browser keeps the focus in it and gives it back. */
export function Help() {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (open.value) dialog.current?.showModal();
    else dialog.current?.close();
  }, [open.value]);
  const groups = new Map<string, Binding[]>();
  for (const binding of bindings.value) groups.set(binding.group(), [...(groups.get(binding.group()) ?? []), binding]);
  return (
    <dialog
      ref={dialog}
      class="help"
      aria-labelledby="help-title"
      onClose={() => { open.value = false; }}
      onKeyDown={(event) => { if (event.key === "?") open.value = false; }}
      onClick={(event) => { if (event.target === dialog.current) open.value = false; }}
    >
      <header>
        <h2 id="help-title">{t("helpTitle")}</h2>
        <button class="button ghost icon-only" aria-label={t("close")} onClick={() => { open.value = false; }}><Icon name="close" /></button>
      </header>
      <div class="help-groups">
        {[...groups].map(([group, list]) => (
          <section key={group}>
            <h3>{group}</h3>
            <dl>
              {list.map((binding) => (
                <div key={binding.label}><dt><kbd>{binding.label}</kbd></dt><dd>{binding.meaning()}</dd></div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </dialog>
  );
}
