// SPDX-License-Identifier: MIT
// How the engine is: its state and its reason, all its figures, its log; and the buttons that start and stop it.
import { effect } from "@preact/signals";

import { FigureHistory } from "../lib/figure_history";
import { linkTo } from "../shell/router";
import { sayError } from "../shell/toast";
import type { Store } from "../store/store";
import { useStore, useStudio } from "../studio";
import { Figures, Stages } from "./health/figures";
import { Log } from "./health/log";
import { t } from "./health/texts";
import { useMayChange, ViewerNote } from "./shared/notes";

const histories = new WeakMap<Store, FigureHistory>();

/** Kept from the first visit on, also while other pages are shown. */
function historyOf(store: Store): FigureHistory {
  let history = histories.get(store);
  if (!history) {
    history = new FigureHistory();
    histories.set(store, history);
    const kept = history;
    effect(() => {
      if (store.health.value) kept.push(performance.now() / 1000, store.health.value);
    });
  }
  return history;
}

export function HealthPage() {
  const store = useStore();
  const history = historyOf(store);
  const health = store.health.value;
  const run = store.run.value;
  return (
    <div class="page">
      <h1 class="page-title">{t("title")}</h1>
      <ViewerNote />
      <EnginePanel />
      <section class="panel" aria-labelledby="figures-title">
        <header>
          <h2 id="figures-title">{t("figures")}</h2>
          <span class="soft small-text">{[store.hello.value?.server, run?.source, run && t("rate", { rate: run.rate, hop: run.hop })].filter(Boolean).join(" · ")}</span>
        </header>
        {health ? <Figures health={health} history={history} now={history.rows.at(-1)?.at ?? 0} /> : <div class="empty"><h3>{t("noFigures")}</h3><p>{t("noFiguresNext")}</p></div>}
      </section>
      {health && <Stages stages={health.stages ?? []} />}
      <Log />
    </div>
  );
}

function EnginePanel() {
  const { store, call } = useStudio();
  const may = useMayChange() && store.can("engine");
  const engine = store.engine.value;
  const state = engine?.state;
  const going = state === "running" || state === "starting" || state === "waiting";
  const act = (method: string) => () => void call(method).catch(sayError);
  return (
    <section class={`panel engine-panel ${state ?? ""}`} aria-labelledby="engine-title">
      <div class="engine-state">
        <h2 id="engine-title" class="soft small-text">{t("engine")}</h2>
        <strong class="engine-word">{state ? t(`state_${state}`) : t("unknown")}</strong>
        {engine?.what && <p class="engine-what">{engine.what}</p>}
        {state && <p class="soft small-text">{t(`next_${state}`)}</p>}
        {state === "idle" && <a class="button small" href={linkTo("configuration")}>{t("toConfig")}</a>}
      </div>
      {store.operator.value && (
        <div class="row-wrap">
          <button class="button" disabled={!may || going} onClick={act("engine.start")}>{t("start")}</button>
          <button class="button" disabled={!may || !going} onClick={act("engine.stop")}>{t("stop")}</button>
          <button class="button" disabled={!may} onClick={act("engine.restart")}>{t("restart")}</button>
        </div>
      )}
    </section>
  );
}
