// SPDX-License-Identifier: MIT
// A question before something that cannot simply be taken back.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { t } from "./texts";

interface Props {
  title: string;
  action: string;
  danger?: boolean;
  onAnswer: (yes: boolean) => void;
  children?: ComponentChildren;
}

export function Confirm({ title, action, danger = false, onAnswer, children }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const answered = useRef(false);
  const before = useRef<Element | null>(null);
  useEffect(() => {
    before.current = document.activeElement;
    dialog.current?.showModal();
    return () => (before.current as HTMLElement | null)?.focus?.();
  }, []);
  const answer = (yes: boolean) => {
    if (answered.current) return;
    answered.current = true;
    onAnswer(yes);
  };
  return (
    <dialog ref={dialog} class="confirm" aria-labelledby="confirm-title" onClose={() => answer(false)}>
      <h2 id="confirm-title">{title}</h2>
      <div class="confirm-body">{children}</div>
      <div class="confirm-buttons">
        <button class="button" onClick={() => answer(false)}>{t("cancel")}</button>
        <button class={`button ${danger ? "danger" : "primary"}`} onClick={() => answer(true)}>{action}</button>
      </div>
    </dialog>
  );
}
