// SPDX-License-Identifier: MIT
import { chosenLanguage, type Language } from "../i18n/i18n";
import { useStudio } from "../studio";
import { announcing } from "./announce";
import { toggleHelp } from "./help";
import { Icon } from "./icons";
import { Menu } from "./menu";
import { kRoutes, linkTo, place } from "./router";
import { StateChip } from "./statechip";
import { t } from "./texts";
import { kThemes, theme, type Theme } from "./theme";
import { say, sayError } from "./toast";
import { angleUnit, type AngleUnit } from "./units";

export function TopBar() {
  return (
    <header class="topbar">
      <a class="brand" href={linkTo("live")}>
        <img src="favicon.svg" alt="" width="26" height="26" />
        <span>ODAS <b>Studio</b></span>
      </a>
      <nav aria-label={t("pages")}>
        {kRoutes.map((route) => (
          <a key={route} href={linkTo(route)} aria-current={place.value.route === route ? "page" : undefined}>
            {route === "configuration" ? (
              <>
                <span class="wide">{t("configuration")}</span>
                <span class="narrow">{t("configurationShort")}</span>
              </>
            ) : (
              t(route)
            )}
          </a>
        ))}
      </nav>
      <div class="topbar-tools">
        <StateChip />
        <RecordMenu />
        <EngineMenu />
        <SettingsMenu />
        <button class="button ghost icon-only" aria-label={t("help")} title={`${t("help")} (?)`} onClick={toggleHelp}><Icon name="help" /></button>
      </div>
    </header>
  );
}

function RecordMenu() {
  const { store, call } = useStudio();
  if (!store.can("record") || !store.operator.value || !store.connected.value) return null;
  const active = store.recording.value;
  const start = (what: "all" | "raw" | "session") => () => {
    const params = what === "all" ? { what, stream: "separated" } : { what };
    call<{ name?: string }>("record.start", params).then((result) => say(result?.name ?? t("record")), sayError);
  };
  const stop = () => void call("record.stop", { all: true }).catch(sayError);
  const busy = active.length > 0;
  const label = busy ? t("recordingN", { n: active.length }) : t("record");
  return (
    <Menu
      class={busy ? "recording" : ""}
      label={label}
      face={<><Icon name="record" filled={busy} /><span class="wide">{label}</span></>}
    >
      <button class="menu-item" onClick={start("all")}>{t("recordAll")}</button>
      <button class="menu-item" onClick={start("raw")}>{t("recordRaw")}</button>
      {store.can("sessions") && <button class="menu-item" onClick={start("session")}>{t("recordSession")}</button>}
      {busy && <button class="menu-item strong" onClick={stop}>{t("stopAll")}</button>}
    </Menu>
  );
}

function EngineMenu() {
  const { store, call } = useStudio();
  if (!store.can("engine") || !store.operator.value || !store.connected.value) return null;
  const run = (method: string) => () => void call(method).catch(sayError);
  const state = store.engine.value?.state;
  const going = state === "running" || state === "starting" || state === "waiting";
  return (
    <Menu label={t("engine")} face={<Icon name="power" />}>
      {state && <p class="menu-note">{`${t(state)}${store.engine.value?.what ? ` – ${store.engine.value.what}` : ""}`}</p>}
      <button class="menu-item" disabled={going} onClick={run("engine.start")}>{t("start")}</button>
      <button class="menu-item" disabled={!going} onClick={run("engine.stop")}>{t("stop")}</button>
      <button class="menu-item" onClick={run("engine.restart")}>{t("restart")}</button>
    </Menu>
  );
}

function SettingsMenu() {
  return (
    <Menu label={t("settings")} face={<Icon name="sliders" />}>
      <label class="menu-field">
        <span>{t("theme")}</span>
        <select value={theme.value} onChange={(event) => { theme.value = event.currentTarget.value as Theme; }}>
          {kThemes.map((name) => <option key={name} value={name}>{t(`theme_${name}`)}</option>)}
        </select>
      </label>
      <label class="menu-field">
        <span>{t("language")}</span>
        <select
          value={chosenLanguage.value ?? ""}
          onChange={(event) => { chosenLanguage.value = (event.currentTarget.value || null) as Language | null; }}
        >
          <option value="">{t("browserLanguage")}</option>
          <option value="en" lang="en">English</option>
          <option value="fr" lang="fr">Français</option>
        </select>
      </label>
      <label class="menu-field">
        <span>{t("angles")}</span>
        <select value={angleUnit.value} onChange={(event) => { angleUnit.value = event.currentTarget.value as AngleUnit; }}>
          <option value="deg">{t("degrees")}</option>
          <option value="rad">{t("radians")}</option>
        </select>
      </label>
      <label class="menu-check">
        <input type="checkbox" checked={announcing.value} onChange={(event) => { announcing.value = event.currentTarget.checked; }} />
        <span>{t("announce")}</span>
      </label>
    </Menu>
  );
}
