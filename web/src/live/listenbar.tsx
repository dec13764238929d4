// SPDX-License-Identifier: MIT
// What is being heard, how loud and how late. Shown while something is.
import { number } from "../i18n/i18n";
import { Icon } from "../shell/icons";
import { useStudio } from "../studio";
import { colorOf } from "./palette";
import { t } from "./texts";

export function ListenBar() {
  const { store, listener } = useStudio();
  const wish = listener?.wish.value;
  if (!listener || !wish) return null;
  const what = wish.stream === "raw" ? t("raw", { n: wish.mic ?? "" }) : t("voice", { id: wish.track ?? "" });
  const color = wish.track !== undefined ? colorOf(store.tracks.lookOf(wish.track)) : "currentColor";
  const quiet = listener.muted.value || listener.volume.value === 0;
  return (
    <section class="listenbar" aria-label={t("listeningTo", { what })}>
      <span class="listen-what" style={{ "--track": color }}><Icon name="ear" /><b>{what}</b></span>
      {wish.track !== undefined && (
        <label>
          <span class="visually-hidden">{t("stream")}</span>
          <select value={wish.stream} onChange={(event) => listener.listen({ stream: event.currentTarget.value as "separated" | "postfiltered", track: wish.track! })}>
            <option value="separated">{t("separated")}</option>
            <option value="postfiltered">{t("postfiltered")}</option>
          </select>
        </label>
      )}
      <button class="button ghost small icon-only" aria-pressed={listener.muted.value} aria-label={t("mute")} title={t("mute")} onClick={() => { listener.muted.value = !listener.muted.value; }}>
        <Icon name={quiet ? "mute" : "ear"} />
      </button>
      <label class="listen-volume">
        <span class="visually-hidden">{t("volume")}</span>
        <input type="range" min={0} max={1} step={0.01} value={listener.volume.value} onInput={(event) => { listener.volume.value = Number(event.currentTarget.value); }} />
      </label>
      <span class="figures soft listen-facts">
        {listener.latency.value !== null && <span data-latency>{t("latencyMs", { n: number(listener.latency.value) })}</span>}
        {listener.over.value && listener.latency.value === null && <span>{t("voiceOver")}</span>}
        <span>{t("underruns", { n: number(listener.underruns.value) })}</span>
      </span>
      {listener.blocked.value && <button class="button small primary" onClick={() => listener.unblock()}>{t("soundOff")}</button>}
      <button class="button ghost small icon-only" aria-label={t("stopListening")} title={t("stopListening")} onClick={() => listener.stop()}><Icon name="close" /></button>
    </section>
  );
}
