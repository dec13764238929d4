// SPDX-License-Identifier: MIT
// One key of the configuration: its value, what it means, what it may be, what is wrong with it.
import { useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { faultsAt, isChanged, parseTyped, rangeOf, showValue, type Fault, type Field } from "../../lib/config_form";
import type { Draft } from "./draft";
import { t } from "./texts";

interface Props {
  field: Field;
  draft: Draft;
  may: boolean;
}

export function FieldRow({ field, draft, may }: Props) {
  const [problem, setProblem] = useState<string | null>(null);
  const id = `field-${field.path.replace(/[^\w]/g, "-")}`;
  const faults = faultsAt(draft.faults.value, field.path);
  const bad = problem !== null || faults.some((fault) => fault.severity !== "warning");
  const changed = isChanged(field);
  const take = (text: string) => {
    const parsed = parseTyped(field, text);
    if ("problem" in parsed) {
      setProblem(t(`problem_${parsed.problem}`, { n: field.length ?? 0, range: rangeText(field) }));
      return;
    }
    setProblem(null);
    if (text !== showValue(field.value)) void draft.edit([{ path: field.path, value: parsed.value }]);
  };
  const described = `${id}-help${bad ? ` ${id}-fault` : ""}`;
  return (
    <div class={`field ${changed ? "changed" : ""} ${bad ? "bad" : ""}`}>
      <label for={id} class="field-name">
        <code>{field.key}</code>
        {changed && <span class="field-mark" title={t("changed")}><span class="visually-hidden">{t("changed")}</span></span>}
      </label>
      <div class="field-control">
        <Control field={field} id={id} may={may} bad={bad} described={described} onText={take} onValue={(value) => void draft.edit([{ path: field.path, value }])} />
        {field.unit && <span class="soft field-unit">{field.unit}</span>}
        {may && field.written && !field.required && (
          <button class="button ghost small" aria-label={t("reset", { key: field.path })} title={t("reset", { key: field.key })} onClick={() => { setProblem(null); void draft.edit([{ path: field.path, value: null }]); }}>↺</button>
        )}
      </div>
      <div class="field-help soft" id={`${id}-help`}>
        {[field.meaning, rangeText(field), field.required ? t("derived") : t("default", { value: showValue(field.default) || t("defaultNone") })].filter(Boolean).join(" · ")}
      </div>
      <Faults id={`${id}-fault`} problem={problem} faults={faults} />
    </div>
  );
}

interface ControlProps {
  field: Field;
  id: string;
  may: boolean;
  bad: boolean;
  described: string;
  onText: (text: string) => void;
  onValue: (value: unknown) => void;
}

function Control({ field, id, may, bad, described, onText, onValue }: ControlProps) {
  const common = { id, disabled: !may, "aria-invalid": bad, "aria-describedby": described };
  if (field.kind === "bool") {
    return <input type="checkbox" {...common} checked={field.value === true} onChange={(event) => onValue(event.currentTarget.checked)} />;
  }
  if (field.kind === "string" && (field.choices?.length ?? 0) > 0) {
    const value = showValue(field.value);
    const choices = field.choices!.includes(value) ? field.choices! : [value, ...field.choices!];
    return (
      <select {...common} value={value} onChange={(event) => onValue(event.currentTarget.value)}>
        {choices.map((choice) => <option key={choice} value={choice}>{choice === "" ? "–" : choice}</option>)}
      </select>
    );
  }
  const plain = field.kind === "string" || field.kind === "strings";
  return (
    <input
      type="text" {...common} class={plain ? "wide-input" : "number-input"} inputMode={field.kind === "int" ? "numeric" : undefined} spellcheck={false} autocomplete="off"
      value={showValue(field.value)} key={showValue(field.value)} onChange={(event) => onText(event.currentTarget.value)}
    />
  );
}

function Faults({ id, problem, faults }: { id: string; problem: string | null; faults: Fault[] }) {
  if (problem === null && faults.length === 0) return null;
  return (
    <ul id={id} class="field-faults" role="alert">
      {problem !== null && <li class="bad-text">{problem}</li>}
      {faults.map((fault) => <li key={fault.what} class={fault.severity === "warning" ? "warn-text" : "bad-text"}>{fault.what}</li>)}
    </ul>
  );
}

/** "more than 0, at most 1"; "" where anything goes. */
export function rangeText(field: Field): string {
  const { min, max, excluded } = rangeOf(field);
  const show = (value: number) => number(value, Number.isInteger(value) ? 0 : 3);
  if (min !== null && max !== null) return t(excluded ? "rangeExcluded" : "range", { min: show(min), max: show(max) });
  if (min !== null) return t(excluded ? "moreThan" : "atLeast", { min: show(min) });
  return max !== null ? t("atMost", { max: show(max) }) : "";
}
