// SPDX-License-Identifier: MIT
// The configuration as a form, which comes from the fields' own descriptions.
import { useState } from "preact/hooks";

import { countChanged, faultsAt, filterFields, homelessFaults, isChanged, newItem, type Fault, type Field } from "../../lib/config_form";
import type { Draft } from "./draft";
import { FieldRow } from "./field";
import { t } from "./texts";

export function FormView({ draft, may }: { draft: Draft; may: boolean }) {
  const [query, setQuery] = useState("");
  const [onlyChanged, setOnlyChanged] = useState(false);
  const form = draft.form.value;
  if (!form) return <p class="soft">{t("checking")}</p>;
  const sections = form.sections
    .map((section) => ({ ...section, fields: pick(filterFields(section.fields, query), onlyChanged) }))
    .filter((section) => section.fields.length > 0);
  const open = query.trim() !== "" || onlyChanged;
  return (
    <div class="stack">
      <div class="row-wrap" role="search">
        <input type="search" class="grow" value={query} placeholder={t("search")} aria-label={t("search")} onInput={(event) => setQuery(event.currentTarget.value)} />
        <label class="menu-check">
          <input type="checkbox" checked={onlyChanged} onChange={(event) => setOnlyChanged(event.currentTarget.checked)} />
          <span>{t("onlyChanged")}</span>
        </label>
      </div>
      {draft.formOld.value && <p class="note warn" role="status">{t("formOld")}</p>}
      <Homeless faults={homelessFaults(draft.faults.value, form)} />
      {sections.length === 0 && <div class="empty"><h3>{t("nothingFound")}</h3></div>}
      {sections.map((section) => {
        const changed = countChanged(section.fields);
        const faults = faultsAt(draft.faults.value, section.name, true).length;
        return (
          <details key={section.name} class="panel section" open={open || faults > 0 ? true : undefined}>
            <summary>
              <h2>{section.name}</h2>
              {changed > 0 && <span class="soft small-text">{t("changedCount", { n: changed })}</span>}
              {faults > 0 && <span class="badge bad">{t("errors", { n: faults })}</span>}
            </summary>
            <div class="panel-body"><Fields fields={section.fields} draft={draft} may={may} /></div>
          </details>
        );
      })}
    </div>
  );
}

function pick(fields: Field[], onlyChanged: boolean): Field[] {
  if (!onlyChanged) return fields;
  return fields.flatMap((field) => {
    if (field.kind !== "group") return isChanged(field) ? [field] : [];
    const inner = pick(field.fields ?? [], true);
    return inner.length > 0 ? [{ ...field, fields: inner }] : [];
  });
}

function Fields({ fields, draft, may }: { fields: Field[]; draft: Draft; may: boolean }) {
  return (
    <>
      {fields.map((field) => {
        if (field.kind === "group") return <Group key={field.path} field={field} draft={draft} may={may} />;
        if (field.kind === "list") return <List key={field.path} field={field} draft={draft} may={may} />;
        return <FieldRow key={field.path} field={field} draft={draft} may={may} />;
      })}
    </>
  );
}

function Group({ field, draft, may }: { field: Field; draft: Draft; may: boolean }) {
  return (
    <fieldset class="group">
      <legend><code>{field.key}</code></legend>
      {field.meaning && <p class="soft small-text">{field.meaning}</p>}
      <Fields fields={field.fields ?? []} draft={draft} may={may} />
    </fieldset>
  );
}

function List({ field, draft, may }: { field: Field; draft: Draft; may: boolean }) {
  const items = field.items ?? [];
  const faults = faultsAt(draft.faults.value, field.path);
  return (
    <fieldset class="group">
      <legend><code>{field.key}</code><span class="soft small-text">{t("items", { n: items.length })}</span></legend>
      {field.meaning && <p class="soft small-text">{field.meaning}</p>}
      {faults.map((fault) => <p key={fault.what} class={fault.severity === "warning" ? "warn-text" : "bad-text"} role="alert">{fault.what}</p>)}
      <ol class="items">
        {items.map((item, i) => {
          const path = `${field.path}[${i}]`;
          return (
            <li key={i}>
              <div class="item-head">
                <strong class="small-text">{t("itemN", { key: field.key, n: i + 1 })}</strong>
                {may && <button class="button ghost small" aria-label={t("removeItem", { n: i + 1, key: field.path })} onClick={() => void draft.edit([{ path, value: null }])}>{t("remove")}</button>}
              </div>
              {faultsAt(draft.faults.value, path).map((fault) => <p key={fault.what} class="bad-text" role="alert">{fault.what}</p>)}
              <Fields fields={item} draft={draft} may={may} />
            </li>
          );
        })}
      </ol>
      {may && <button class="button small" aria-label={t("addTo", { key: field.path })} onClick={() => void draft.edit([{ path: `${field.path}[${items.length}]`, value: newItem(field) }])}>{t("add")}</button>}
    </fieldset>
  );
}

function Homeless({ faults }: { faults: Fault[] }) {
  if (faults.length === 0) return null;
  return (
    <div class="note bad" role="alert">
      <strong>{t("elsewhere")}</strong>
      <ul>{faults.map((fault) => <li key={`${fault.line} ${fault.what}`}>{faultText(fault)}</li>)}</ul>
    </div>
  );
}

export function faultText({ line, path, what }: Fault): string {
  return [line ? t("line", { n: line }) : "", path ?? "", what].filter(Boolean).join(": ");
}
