// SPDX-License-Identifier: MIT
// What the draft changes of what runs.
import { useMemo } from "preact/hooks";

import { diffLines, hunks } from "../../lib/text_diff";
import type { Draft } from "./draft";
import { t } from "./texts";

export function DiffView({ draft }: { draft: Draft }) {
  const before = draft.running.value?.text ?? "";
  const after = draft.text.value ?? "";
  const lines = useMemo(() => hunks(diffLines(before, after)), [before, after]);
  if (lines.length === 0) {
    return <div class="empty"><h3>{t("sameText")}</h3><p>{t("sameTextNext")}</p></div>;
  }
  return (
    <div class="table-scroll" tabIndex={0} role="group" aria-label={t("tab_changes")}>
      <table class="diff">
        <tbody>
          {lines.map((line, i) => line === null ? (
            <tr key={i} class="skipped"><td colSpan={4}>⋯</td></tr>
          ) : (
            <tr key={i} class={line.kind}>
              <td class="number">{line.before ?? ""}</td>
              <td class="number">{line.after ?? ""}</td>
              <td class="sign">
                <span aria-hidden="true">{line.kind === "added" ? "+" : line.kind === "removed" ? "−" : ""}</span>
                {line.kind !== "same" && <span class="visually-hidden">{t(line.kind === "added" ? "addedLine" : "removedLine")}</span>}
              </td>
              <td class="code">{line.text}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
