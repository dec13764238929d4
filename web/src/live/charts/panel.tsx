// SPDX-License-Identifier: MIT
import { Icon } from "../../shell/icons";
import { kSpans, useView } from "../view";
import { t } from "../texts";
import { Chart } from "./chart";
import { clock } from "./draw";

export function ChartsPanel() {
  const view = useView();
  const held = view.held.value;
  void view.pulse.value;
  const behind = held === null ? 0 : view.store.now - held;
  return (
    <section class="panel charts" aria-label={t("charts")}>
      <header>
        <h2>{t("charts")}</h2>
        {held !== null && (
          <button class="pill" onClick={() => view.goLive()}>
            <Icon name="play" filled />
            <span>{t("backToLive", { time: clock(Math.max(0, behind)) })}</span>
          </button>
        )}
        <label class="inline-field">
          <span class="visually-hidden">{t("span")}</span>
          <select value={view.span.value} onChange={(event) => { view.span.value = Number(event.currentTarget.value); }}>
            {[...new Set([...kSpans, view.span.value])].sort((a, b) => a - b).map((span) => (
              <option key={span} value={span}>{span < 60 ? `${span} s` : `${span / 60} min`}</option>
            ))}
          </select>
        </label>
        <button class="button ghost icon-only" aria-label={t("earlier")} title={t("earlier")} onClick={() => view.scroll(-view.span.value / 2)}><Icon name="back" /></button>
        <button class="button ghost icon-only" aria-label={t("later")} title={t("later")} disabled={held === null} onClick={() => view.scroll(view.span.value / 2)}><Icon name="forward" /></button>
        <button
          class="button ghost icon-only"
          aria-pressed={view.paused.value}
          aria-label={t("pause")}
          title={`${t("pause")} (${t("spaceKey")})`}
          onClick={() => view.togglePause()}
        >
          <Icon name={view.paused.value ? "play" : "pause"} />
        </button>
      </header>
      <Chart kind="az" />
      <Chart kind="el" />
    </section>
  );
}
