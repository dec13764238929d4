// SPDX-License-Identifier: MIT
// The level of each microphone, and what is wrong with it.
import { number } from "../../i18n/i18n";
import { Icon } from "../../shell/icons";
import { MicFlag } from "../../socket/messages";
import { useStudio } from "../../studio";
import { t } from "../texts";
import { useView } from "../view";

const kFloor = -72;

/** Share of the meter that `level` (dB) fills. */
function share(level: number | null): number {
  return level === null ? 0 : Math.max(0, Math.min(1, 1 - level / kFloor));
}

export function MetersPanel() {
  const view = useView();
  const studio = useStudio();
  const mics = studio.store.meters.value?.mics ?? [];
  const faults = mics.reduce((all, [, , flags]) => all | (flags ?? 0), 0);
  return (
    <section class="panel meters" aria-label={t("microphones")}>
      <header><h2>{t("microphones")}</h2></header>
      <div class="panel-body">
        {mics.length === 0 && <p class="soft">{t("noMeters")}</p>}
        <ul>
          {mics.map(([rms, peak, flags = 0, same], k) => {
            const heard = studio.listener?.wish.value?.mic === k + 1;
            const words = [
              flags & MicFlag.clipped ? t("clipped") : "",
              flags & MicFlag.dead ? t("dead") : "",
              flags & MicFlag.duplicate ? t("duplicate", { n: same ?? "?" }) : "",
            ].filter(Boolean);
            return (
              <li key={k} class={`${view.mic.value === k ? "selected" : ""} ${words.length > 0 ? "faulty" : ""}`} data-mic={k + 1}>
                <button class="mic-name" aria-pressed={view.mic.value === k} aria-label={t("mic", { n: k + 1 })} onClick={() => { view.mic.value = view.mic.value === k ? null : k; }}>{k + 1}</button>
                <span class="mic-bar" role="img" aria-label={rms === null ? "–" : `${number(rms)} dB`}>
                  <span class="mic-fill" style={{ clipPath: `inset(0 ${100 - 100 * share(rms)}% 0 0)` }} />
                  <span class="mic-peak" style={{ left: `${100 * share(peak)}%` }} />
                </span>
                {words.length > 0 ? (
                  <span class={`badge ${flags & MicFlag.clipped ? "bad" : "warn"}`}>{words.join(", ")}</span>
                ) : (
                  <span class="figures soft mic-level">{rms === null ? "–" : `${number(rms)} dB`}</span>
                )}
                {studio.listener && (
                  <button
                    class="button ghost small icon-only"
                    aria-pressed={heard}
                    aria-label={`${t(heard ? "stopListening" : "listen")}: ${t("mic", { n: k + 1 })}`}
                    onClick={() => (heard ? studio.listener!.stop() : studio.listener!.listen({ stream: "raw", mic: k + 1 }))}
                  ><Icon name="ear" /></button>
                )}
              </li>
            );
          })}
        </ul>
        {(faults & MicFlag.clipped) !== 0 && <p class="hint">{t("clippedNext")}</p>}
        {(faults & MicFlag.dead) !== 0 && <p class="hint">{t("deadNext")}</p>}
        {(faults & MicFlag.duplicate) !== 0 && <p class="hint">{t("duplicateNext")}</p>}
      </div>
    </section>
  );
}
