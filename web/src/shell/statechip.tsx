// SPDX-License-Identifier: MIT
import { number } from "../i18n/i18n";
import { useStore } from "../studio";
import { linkTo } from "./router";
import { t } from "./texts";

/** How the daemon is, in one glance: "Live 125 hops/s, 18 ms, 0 dropped". Leads to the page of its health. */
export function StateChip() {
  const store = useStore();
  const link = store.link.value;
  const state = store.engine.value?.state;
  const health = store.health.value;
  const words =
    link === "live" ? t("linkLive") : link === "stale" ? t("stale") : link === "offline" ? t("offline") : link === "connecting" ? t("connecting") : t(state === "running" || !state ? "idle" : state);
  const drops = (health?.dropped_hops ?? 0) + (health?.client_dropped ?? 0) + store.missed.value;
  return (
    <a class={`chip ${link} ${link === "still" ? (state ?? "idle") : ""}`} href={linkTo("health")} data-state={link} title={store.engine.value?.what ?? words}>
      <span class="dot" aria-hidden="true" />
      <span>{words}</span>
      {link === "live" && (
        <span class="chip-figures">
          <span>{t("hopsPerSecond", { n: number(store.pace.value) })}</span>
          {typeof health?.latency === "number" && <span>{t("latency", { n: number(health.latency * 1000) })}</span>}
          <span class={drops > 0 ? "bad" : ""}>{t("drops", { n: number(drops) })}</span>
        </span>
      )}
      {!store.operator.value && <span class="chip-role">{t("viewer")}</span>}
    </a>
  );
}
