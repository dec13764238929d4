// SPDX-License-Identifier: MIT
// What is being recorded at this moment, the buttons that begin and end it, and how much room is left.
import { useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { bytes, clock } from "../../lib/bytes";
import { Icon } from "../../shell/icons";
import { say, sayError } from "../../shell/toast";
import type { ActiveRecording } from "../../socket/messages";
import { useStudio } from "../../studio";
import { useMayChange } from "../shared/notes";
import { t } from "./texts";

const kLow = 1e9;

export function Now() {
  const { store, call } = useStudio();
  const [stream, setStream] = useState<"separated" | "postfiltered">("separated");
  const may = useMayChange() && store.can("record");
  const active = store.recording.value;
  const free = store.diskFree.value;
  const folder = store.hello.value?.recordings;
  const begin = (params: object) => () =>
    void call<{ name?: string }>("record.start", params).then((result) => say(t("started", { name: result?.name ?? "" })), sayError);
  const end = (params: object) =>
    void call<{ names?: string[] }>("record.stop", params).then((result) => say(t("saved", { names: (result?.names ?? []).join(", ") })), sayError);
  const running = store.run.value !== null;
  return (
    <section class="panel" aria-labelledby="now-title">
      <header>
        <h2 id="now-title">{t("now")}</h2>
        {active.length > 1 && <button class="button small" disabled={!may} onClick={() => end({ all: true })}>{t("stopAll")}</button>}
      </header>
      <div class="panel-body stack">
        {active.length === 0 && <p class="soft">{t("nothingNow")}</p>}
        <ul class="active-list">
          {active.map((one) => (
            <li key={one.id}>
              <span class="recording-dot" aria-hidden="true" />
              <span>{whatOf(one)}</span>
              <span class="figures soft">{clock(one.seconds ?? 0)}</span>
              <button class="button small" disabled={!may} aria-label={`${t("stop")}: ${whatOf(one)}`} onClick={() => end({ id: one.id })}>
                <Icon name="stop" filled />{t("stop")}
              </button>
            </li>
          ))}
        </ul>
        {store.operator.value && (
          <div class="row-wrap">
            <button class="button" disabled={!may || !running} onClick={begin({ what: "all", stream })}><Icon name="record" />{t("recordAll")}</button>
            <label class="inline-field">
              <span>{t("stream")}</span>
              <select value={stream} onChange={(event) => setStream(event.currentTarget.value as typeof stream)}>
                <option value="separated">{t("separated")}</option>
                <option value="postfiltered">{t("postfiltered")}</option>
              </select>
            </label>
            <button class="button" disabled={!may || !running} onClick={begin({ what: "raw" })}><Icon name="record" />{t("recordRaw")}</button>
            {store.can("sessions") && (
              <button class="button" disabled={!may || !running} onClick={begin({ what: "session" })}><Icon name="record" />{t("recordSession")}</button>
            )}
          </div>
        )}
        <p class="soft small-text">
          {free !== null && <span class={free < kLow ? "warn-text" : ""}>{t(free < kLow ? "diskLow" : "diskFree", { size: bytes(free, number) })}</span>}
          {folder && <span class="folder">{t("folder", { path: folder })}</span>}
        </p>
      </div>
    </section>
  );
}

function whatOf({ what, track, name }: ActiveRecording): string {
  if (what === "track" && track !== undefined) return t("what_track", { n: track });
  return what === "all" || what === "raw" || what === "session" ? t(`what_${what}`) : (name ?? "");
}
