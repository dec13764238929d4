// SPDX-License-Identifier: MIT
// The frame around every page.
import type { ComponentType } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { LivePage } from "./live/page";
import { followOpenSession } from "./pages/replay/open_session";
import { Banners } from "./shell/banners";
import { Help, toggleHelp } from "./shell/help";
import { followKeys, useKeys } from "./shell/keys";
import { lazy } from "./shell/lazy";
import { kiosk, kRoutes, linkTo, place, type Route } from "./shell/router";
import { t } from "./shell/texts";
import { nextTheme } from "./shell/theme";
import { Toasts } from "./shell/toast";
import { TopBar } from "./shell/topbar";
import { StudioContext, type Studio } from "./studio";

const kPages: Record<Route, ComponentType> = {
  live: LivePage,
  recordings: lazy(async () => (await import("./pages/recordings")).RecordingsPage),
  replay: lazy(async () => (await import("./pages/replay")).ReplayPage),
  configuration: lazy(async () => (await import("./pages/configuration")).ConfigurationPage),
  health: lazy(async () => (await import("./pages/health")).HealthPage),
};

export function App({ studio, retry }: { studio: Studio; retry: () => void }) {
  const route = place.value.route;
  const main = useRef<HTMLElement>(null);
  const shown = useRef(route);

  useEffect(followKeys, []);
  useEffect(() => followOpenSession(studio.store), []);
  useEffect(() => {
    document.title = `${t(route)} – ODAS Studio`;
    if (shown.current !== route) main.current?.focus();
    shown.current = route;
  }, [route]);
  useKeys(() => [
    { keys: ["?"], label: "?", meaning: () => t("keyHelp"), group: () => t("generalKeys"), run: toggleHelp },
    { keys: ["t"], label: "T", meaning: () => t("keyTheme"), group: () => t("generalKeys"), run: nextTheme },
    {
      keys: ["g"],
      label: "G",
      meaning: () => t("keyPages"),
      group: () => t("generalKeys"),
      run: () => {
        location.hash = linkTo(kRoutes[(kRoutes.indexOf(place.value.route) + 1) % kRoutes.length]!);
      },
    },
  ]);

  const Page = kPages[route];
  return (
    <StudioContext.Provider value={studio}>
      <a class="skip" href="#main" onClick={(event) => { event.preventDefault(); main.current?.focus(); }}>{t("skip")}</a>
      {!kiosk && <TopBar />}
      <Banners retry={retry} />
      <main id="main" ref={main} tabIndex={-1} class={kiosk ? "kiosk" : ""}>
        <Page key={route} />
      </main>
      <Help />
      <Toasts />
    </StudioContext.Provider>
  );
}
