// SPDX-License-Identifier: MIT
// Which sound, which microphones, and everything that can be set.
import { useEffect, useState } from "preact/hooks";

import { place, replaceQuery } from "../shell/router";
import { useStudio } from "../studio";
import { ArrayView } from "./configuration/array_view";
import { Bar } from "./configuration/bar";
import { DiffView } from "./configuration/diff_view";
import { draftOf } from "./configuration/draft";
import { FirstRun } from "./configuration/first_run";
import { FormView } from "./configuration/form_view";
import { t } from "./configuration/texts";
import { TextView } from "./configuration/text_view";
import { useMayChange, ViewerNote } from "./shared/notes";

const kTabs = ["array", "form", "text", "changes"] as const;
type Tab = (typeof kTabs)[number];

export function ConfigurationPage() {
  const studio = useStudio();
  const { store } = studio;
  const draft = draftOf(studio);
  const may = useMayChange();
  const [choosing, setChoosing] = useState(false);
  const run = store.run.value;
  useEffect(() => {
    if (store.connected.value && run) void draft.load();
  }, [store.connected.value, run?.config_hash, run?.id]);

  if (store.connected.value && (!run || choosing)) {
    return (
      <div class="page">
        <h1 class="page-title">{t("title")}</h1>
        <FirstRun onOpened={() => setChoosing(false)} />
      </div>
    );
  }
  const wanted = place.value.query.get("tab") as Tab;
  const tab = kTabs.includes(wanted) ? wanted : "array";
  return (
    <div class="page">
      <h1 class="page-title">{t("title")}</h1>
      <ViewerNote />
      {draft.problem.value && draft.text.value === null ? (
        <div class="empty" role="alert">
          <h2>{t("loadFailed", { why: draft.problem.value.message })}</h2>
          <button class="button" onClick={() => void draft.load()}>{t("tryAgain")}</button>
        </div>
      ) : (
        <>
          <Bar draft={draft} may={may} />
          <div class="row-wrap">
            <Tabs tab={tab} />
            {may && <button class="button ghost small push" onClick={() => setChoosing(true)}>{t("change")}</button>}
          </div>
          <div id="tab-panel" role="tabpanel" aria-labelledby={`tab-${tab}`}>
            {tab === "array" && <ArrayView draft={draft} may={may} />}
            {tab === "form" && <FormView draft={draft} may={may} />}
            {tab === "text" && <TextView draft={draft} may={may} />}
            {tab === "changes" && <DiffView draft={draft} />}
          </div>
          {draft.plan.value && (
            <details class="panel section">
              <summary><h2>{t("plan")}</h2></summary>
              <pre class="panel-body plan" tabIndex={0}>{draft.plan.value}</pre>
            </details>
          )}
        </>
      )}
    </div>
  );
}

function Tabs({ tab }: { tab: Tab }) {
  const go = (name: Tab) => replaceQuery(new URLSearchParams(name === "array" ? {} : { tab: name }));
  const press = (event: KeyboardEvent) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by) return;
    event.preventDefault();
    const next = kTabs[(kTabs.indexOf(tab) + by + kTabs.length) % kTabs.length]!;
    go(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <div class="tabs" role="tablist" aria-label={t("views")} onKeyDown={press} data-own-keys>
      {kTabs.map((name) => (
        <button key={name} id={`tab-${name}`} role="tab" aria-selected={tab === name} aria-controls={tab === name ? "tab-panel" : undefined} tabIndex={tab === name ? 0 : -1} onClick={() => go(name)}>
          {t(`tab_${name}`)}
        </button>
      ))}
    </div>
  );
}
