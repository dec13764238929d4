// SPDX-License-Identifier: MIT
// Why there is no voice to see, and the next step.
import { linkTo } from "../../shell/router";
import { sayError } from "../../shell/toast";
import { useStudio } from "../../studio";
import { t } from "../texts";
import { useView } from "../view";

export function Nothing() {
  const { store, call } = useStudio();
  const view = useView();
  const link = store.link.value;
  if (view.paused.value) return <div class="empty"><p>{t("heldEmpty")}</p></div>;
  if (link === "live") {
    return (
      <div class="empty">
        <Ripples />
        <h3>{t("noVoices")}</h3>
        <p>{t("noVoicesNext")}</p>
      </div>
    );
  }
  const state = store.engine.value?.state ?? "idle";
  const words = link === "still" ? t(`state_${state}`) : link === "stale" ? t("state_stale", { n: 1 }) : t(link === "offline" ? "state_offline" : "state_connecting");
  const last = store.log.value.at(-1)?.text;
  const stopped = state === "stopped" || state === "ended" || state === "failed";
  return (
    <div class="empty">
      <h3>{t("waitingTitle")}</h3>
      <p>{words}</p>
      {link === "still" && store.engine.value?.what && <p>{store.engine.value.what}</p>}
      {last && <p class="mono small">{t("lastLog", { text: last })}</p>}
      {link === "still" && stopped && store.run.value && store.operator.value && (
        <button class="button primary" onClick={() => void call("engine.start").catch(sayError)}>{t("startEngine")}</button>
      )}
      {link === "still" && store.run.value === null && <a class="button primary" href={linkTo("configuration")}>{t("openConfiguration")}</a>}
    </div>
  );
}

function Ripples() {
  return (
    <svg class="ripples" viewBox="0 0 64 64" aria-hidden="true" fill="none" stroke="currentColor" stroke-width="1.5" stroke-linecap="round">
      <circle cx="32" cy="32" r="3" fill="currentColor" stroke="none" />
      <path d="M32 20a12 12 0 0 1 12 12 M32 11a21 21 0 0 1 21 21 M32 44a12 12 0 0 1-12-12 M32 53a21 21 0 0 1-21-21" />
    </svg>
  );
}
