// SPDX-License-Identifier: MIT
// The configuration as text: a plain field with line numbers, and a mark at each line with a fault.
import { useEffect, useRef } from "preact/hooks";

import type { Draft } from "./draft";
import { faultText } from "./form_view";
import { t } from "./texts";

export function TextView({ draft, may }: { draft: Draft; may: boolean }) {
  const area = useRef<HTMLTextAreaElement>(null);
  const gutter = useRef<HTMLOListElement>(null);
  const text = draft.text.value ?? "";
  const lines = text.split("\n").length;
  const marks = new Map<number, string[]>();
  for (const fault of draft.faults.value) if (fault.line) marks.set(fault.line, [...(marks.get(fault.line) ?? []), fault.what]);
  const follow = () => {
    gutter.current!.scrollTop = area.current!.scrollTop;
  };
  useEffect(follow, [lines]);
  const goTo = (line: number) => {
    const start = text.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    area.current!.focus();
    area.current!.setSelectionRange(start, start);
    area.current!.scrollTop = Math.max(0, (line - 6) * parseFloat(getComputedStyle(area.current!).lineHeight));
    follow();
  };
  return (
    <div class="stack">
      <div class="editor">
        <ol class="gutter" ref={gutter} aria-hidden="true">
          {Array.from({ length: lines }, (_, i) => <li key={i} class={marks.has(i + 1) ? "marked" : ""} title={marks.get(i + 1)?.join("\n")}>{i + 1}</li>)}
        </ol>
        <textarea
          ref={area} aria-label={t("textLabel")} aria-describedby="text-faults" spellcheck={false} autocomplete="off" wrap="off" readOnly={!may}
          value={text} onInput={(event) => draft.type(event.currentTarget.value)} onScroll={follow}
        />
      </div>
      <ul id="text-faults" class="text-faults">
        {draft.faults.value.map((fault) => (
          <li key={`${fault.line} ${fault.path} ${fault.what}`} class={fault.severity === "warning" ? "warn-text" : "bad-text"}>
            {fault.line ? <button class="link" onClick={() => goTo(fault.line!)}>{faultText(fault)}</button> : faultText(fault)}
          </li>
        ))}
      </ul>
    </div>
  );
}
