// SPDX-License-Identifier: MIT
import { useStudio } from "../../studio";
import { t } from "../texts";
import { useView } from "../view";
import { voicesOf } from "../voices";
import { Card } from "./card";
import { Nothing } from "./nothing";

export function CardsPanel() {
  const view = useView();
  const { store } = useStudio();
  void [view.pulse.value, store.epoch.value, store.link.value];
  // While the view is held, the pointer in the charts chooses the moment.
  if (view.paused.value) void view.cursor.value;
  const voices = voicesOf(view);
  return (
    <section class="panel voices" aria-label={t("sources")}>
      <header>
        <h2>{t("sources")}</h2>
        {voices.length > 0 && <span class="count">{voices.length}</span>}
      </header>
      {voices.length > 0 ? (
        <ul class="cards" data-own-scroll>
          {voices.map((voice) => <Card key={voice.id} voice={voice} />)}
        </ul>
      ) : (
        <Nothing />
      )}
    </section>
  );
}
