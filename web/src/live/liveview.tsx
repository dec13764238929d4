// SPDX-License-Identifier: MIT
// Everything that is seen of a run. The page of the daemon shows it, and that of a replay with a store of its own.
import { useEffect, useMemo } from "preact/hooks";

import { Extras, ExtrasButtons } from "../pages/extras";
import { useStudio } from "../studio";
import { Announcer } from "./announcer";
import { FiltersPanel } from "./cards/filterspanel";
import { CardsPanel } from "./cards/panel";
import { ChartsPanel } from "./charts/panel";
import { HealthStrip } from "./inspector/health";
import { LogTail } from "./inspector/log";
import { MetersPanel } from "./inspector/meters";
import { ListenBar } from "./listenbar";
import { TargetsPanel } from "./sphere/pin";
import { SpherePanel } from "./sphere/panel";
import { View, ViewContext } from "./view";
import { useViewKeys } from "./viewkeys";

/** Milliseconds between two looks at words and numbers. */
const kPulse = 125;

/** `replay`: without what belongs to an engine that runs. `use` may call hooks with the view. */
export function LiveView({ replay = false, use = () => {} }: { replay?: boolean; use?: (view: View) => void }) {
  const studio = useStudio();
  const view = useMemo(() => new View(studio.store), [studio.store]);
  use(view);
  useViewKeys(view, studio);
  useEffect(() => {
    // With the hops, and on without them; so that who begins to speak is seen at once.
    let last = -Infinity;
    const pulse = () => {
      const now = performance.now();
      if (now - last < kPulse) return;
      last = now;
      view.pulse.value++;
    };
    const timer = setInterval(pulse, kPulse);
    const beats = studio.store.beat.subscribe(pulse);
    let first = true;
    const stop = studio.store.epoch.subscribe(() => {
      if (!first) view.forget();
      first = false;
    });
    return () => {
      clearInterval(timer);
      beats();
      stop();
    };
  }, [view]);
  return (
    <ViewContext.Provider value={view}>
      <div class={`live-page ${replay ? "replay" : ""}`}>
        <div class="live-left">
          <CardsPanel />
          <FiltersPanel />
        </div>
        <div class="live-middle">
          <SpherePanel />
          <ChartsPanel />
          {!replay && <ExtrasButtons />}
        </div>
        {!replay && (
          <div class="live-right">
            <MetersPanel />
            <HealthStrip />
            <TargetsPanel />
            <LogTail />
          </div>
        )}
      </div>
      {!replay && <Extras />}
      <ListenBar />
      <Announcer />
    </ViewContext.Provider>
  );
}
