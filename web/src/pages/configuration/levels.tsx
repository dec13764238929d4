// SPDX-License-Identifier: MIT
// Is each microphone alive, and itself? The first thing to look at with a new array.
import { number } from "../../i18n/i18n";
import { MicFlag } from "../../socket/messages";
import { useStore } from "../../studio";
import { t } from "./texts";

const kFloor = -80;

export function Levels() {
  const meters = useStore().meters.value;
  if (!meters || meters.mics.length === 0) return null;
  return (
    <section class="panel" aria-labelledby="levels-title">
      <header><h2 id="levels-title">{t("levels")}</h2></header>
      <div class="panel-body stack">
        <p class="soft small-text">{t("levelsNext")}</p>
        <ul class="levels">
          {meters.mics.map(([rms, , flags = 0, twin], i) => {
            const level = rms ?? kFloor;
            const share = Math.min(1, Math.max(0, 1 - level / kFloor));
            const words = [
              flags & MicFlag.clipped ? t("flag_clipped") : "", flags & MicFlag.dead ? t("flag_dead") : "",
              flags & MicFlag.duplicate ? t("flag_duplicate", { n: twin ?? "?" }) : "",
            ].filter(Boolean).join(", ");
            return (
              <li key={i}>
                <span class="figures">{i + 1}</span>
                <span class="level" role="meter" aria-label={t("micLevel", { n: i + 1, level: number(level) })} aria-valuemin={kFloor} aria-valuemax={0} aria-valuenow={Math.round(Math.max(level, kFloor))}>
                  <span style={{ width: `${share * 100}%` }} />
                </span>
                {words && <span class="badge warn">{words}</span>}
              </li>
            );
          })}
        </ul>
      </div>
    </section>
  );
}
