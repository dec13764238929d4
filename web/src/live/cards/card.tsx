// SPDX-License-Identifier: MIT
import { Swatch } from "./swatch";
import { number } from "../../i18n/i18n";
import { clock } from "../../lib/bytes";
import { Icon } from "../../shell/icons";
import { angle } from "../../shell/units";
import type { Beam } from "../../store/store";
import { useStudio } from "../../studio";
import { toggleListening, toggleRecording } from "../actions";
import { colorOf } from "../palette";
import { t } from "../texts";
import { useView } from "../view";
import type { Voice } from "../voices";

/** dB at which the meter is empty. */
const kFloor = -60;

function ago(seconds: number): string {
  return seconds < 60 ? `${number(Math.floor(seconds))} s` : clock(seconds);
}

export function Card({ voice }: { voice: Voice }) {
  const view = useView();
  const studio = useStudio();
  const { store } = studio;
  const { id } = voice;
  const shown = view.shows(id);
  const level = voice.level === null ? null : Math.max(0, Math.min(1, 1 - voice.level / kFloor));
  const heard = studio.listener?.wish.value?.track === id;
  const recording = store.recording.value.some((one) => one.track === id);
  const transcripts = store.transcripts.value.get(id);
  const beam = view.paused.value ? undefined : store.beams.value.get(id);
  return (
    <li
      class={`card ${shown ? "" : "dim"} ${view.hovered.value === id ? "pointed" : ""} ${view.selected.value === id ? "selected" : ""}`}
      style={{ "--track": colorOf(voice.look) }}
      data-voice={id}
      onPointerEnter={() => { view.hovered.value = id; }}
      onPointerLeave={() => { view.hovered.value = null; }}
      // Chosen by the keyboard, or once the pointer has let go: the card of the chosen voice is higher, and what moves between
      // pressing and letting go is not pressed.
      onFocusCapture={(event) => { if ((event.target as Element).matches(":focus-visible")) view.selected.value = id; }}
      onClick={() => { view.selected.value = id; }}
    >
      <button class="card-head" aria-pressed={view.selected.value === id}>
        <Swatch look={voice.look} />
        <span class="card-id">{`#${id}`}</span>
        {voice.tag !== "dynamic" && <span class="badge">{voice.tag}</span>}
        <span class="card-angles figures">
          <span class="visually-hidden">{`${t("azimuth")} `}</span>{angle(voice.az)}
          <span aria-hidden="true"> / </span>
          <span class="visually-hidden">{` ${t("elevation")} `}</span>{angle(voice.el)}
        </span>
      </button>
      <div class="card-meter" role="img" aria-label={`${t("level")} ${voice.level === null ? "–" : `${number(voice.level)} dB`}`}>
        <span style={{ transform: `scaleX(${level ?? 0})` }} />
      </div>
      <div class="card-tools">
        <Tool name={shown ? "eye" : "eyeOff"} label={t(shown ? "hide" : "show")} hint="H" pressed={!shown} run={() => view.toggleHidden(id)} />
        <Tool text="S" label={t("solo")} hint="S" pressed={view.solo.value === id} run={() => view.toggleSolo(id)} />
        {studio.listener && <Tool name="ear" label={t(heard ? "stopListening" : "listen")} hint="L" pressed={heard} run={() => toggleListening(studio, id)} wide />}
        {store.can("record") && store.operator.value && (
          <Tool name={recording ? "stop" : "record"} label={t(recording ? "stopRecording" : "record")} hint="R" pressed={recording} run={() => toggleRecording(studio, id)} record />
        )}
      </div>
      <div class="card-facts figures">
        <span>{voice.level === null ? "– dB" : `${number(voice.level)} dB`}</span>
        <span>{`${t("activity")} ${number(voice.activity, 2)}`}</span>
        <span>{t("age", { time: ago(voice.age) })}</span>
        {voice.category > 0 && <span class={voice.category === 2 ? "speech" : ""}>{t(voice.category === 2 ? "speech" : "noise")}</span>}
      </div>
      {beam && <BeamFacts beam={beam} all={view.selected.value === id} />}
      {transcripts && (
        <p class="card-words" lang="">
          {transcripts.map((one, k) => <span key={k} class={one.final ? "" : "soft"}>{`${one.text} `}</span>)}
        </p>
      )}
    </li>
  );
}

function BeamFacts({ beam: { snr, ...more }, all }: { beam: Beam; all: boolean }) {
  const { gain, condition } = all ? more : { gain: null, condition: null };
  if (snr === null && gain === null && condition === null) return null;
  return (
    <div class="card-facts figures">
      {snr !== null && <span title={t("snrMeans")}>{t("snr", { n: number(snr) })}</span>}
      {gain !== null && <span title={t("beamGainMeans")}>{t("beamGain", { n: number(gain, 1) })}</span>}
      {condition !== null && <span title={t("beamConditionMeans")}>{t("beamCondition", { n: number(condition, 1) })}</span>}
    </div>
  );
}

interface ToolProps {
  name?: Parameters<typeof Icon>[0]["name"];
  text?: string;
  label: string;
  hint: string;
  pressed: boolean;
  run: () => void;
  wide?: boolean;
  record?: boolean;
}

function Tool({ name, text, label, hint, pressed, run, wide, record }: ToolProps) {
  return (
    <button
      class={`button ghost small ${wide ? "" : "icon-only"} ${record ? "record" : ""}`}
      aria-label={label}
      aria-pressed={pressed}
      title={`${label} (${hint})`}
      onClick={run}
    >
      {name ? <Icon name={name} filled={Boolean(record)} /> : <b>{text}</b>}
      {wide && <span aria-hidden="true">{label}</span>}
    </button>
  );
}
