// SPDX-License-Identifier: MIT
// The microphones: in space, in a table, from a template; and what such an array can and cannot do.
import { useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { sharedPlaces } from "../../lib/array_templates";
import { faultsAt, parseTyped, showValue } from "../../lib/config_form";
import { sayError } from "../../shell/toast";
import { angle } from "../../shell/units";
import { azimuth, elevation } from "../../store/angles";
import { useStudio } from "../../studio";
import { useAsked } from "../shared/asked";
import { channelsOf, micsOf, type ArrayCheck } from "./array_model";
import { ArrayScene, mapRange } from "./array_scene";
import type { Draft } from "./draft";
import { Levels } from "./levels";
import { Templates } from "./templates";
import { t } from "./texts";

export function ArrayView({ draft, may }: { draft: Draft; may: boolean }) {
  const [chosen, setChosen] = useState<number | null>(null);
  const [heat, setHeat] = useState(true);
  const form = draft.form.value;
  const mics = micsOf(form);
  const check = useAsked<ArrayCheck>("array.check", { text: draft.text.value ?? "" });
  const sound = draft.errors.value.length === 0 && !draft.formOld.value;
  const result = sound && !check.error ? check.value : null;
  return (
    <div class="array-view">
      <section class="panel" aria-labelledby="array-title">
        <header>
          <h2 id="array-title">{t("arrayTitle")}</h2>
          <label class="menu-check"><input type="checkbox" checked={heat} onChange={(event) => setHeat(event.currentTarget.checked)} /><span>{t("showErrors")}</span></label>
        </header>
        <ArrayScene mics={mics} map={heat ? (result?.error_map ?? undefined) : undefined} chosen={chosen} onChoose={setChosen} />
        {heat && result?.error_map && <Legend map={result.error_map} />}
      </section>
      <Checks check={result} mics={mics.map((mic) => mic.position)} />
      <MicTable draft={draft} may={may} chosen={chosen} onChoose={setChosen} />
      {may && <Templates draft={draft} />}
      {may && <Library draft={draft} />}
      <Levels />
    </div>
  );
}

function Legend({ map }: { map: NonNullable<ArrayCheck["error_map"]> }) {
  const { low, high } = mapRange(map);
  return (
    <p class="legend small-text soft">
      <span class="legend-bar" aria-hidden="true" />
      <span>{`${t("errorMap")}: ${t("errorMapRange", { low: `${number(low, 1)}°`, high: `${number(high, 1)}°` })}`}</span>
    </p>
  );
}

function Checks({ check, mics }: { check: ArrayCheck | null; mics: number[][] }) {
  const twins = sharedPlaces(mics);
  const known = (check?.error_map?.degrees ?? []).filter((value): value is number => value !== null);
  const hertz = (value: number | undefined) => (value ? t("hertz", { n: number(value) }) : "–");
  const twin = check?.ambiguous?.[0];
  const where = (d: [number, number, number]) => `${angle(azimuth(d[0], d[1]))} / ${angle(elevation(...d))}`;
  return (
    <section class="panel" aria-labelledby="checks-title">
      <header><h2 id="checks-title">{t("checks")}</h2></header>
      <div class="panel-body stack">
        {mics.length < 2 && <p class="note warn" role="status">{t("few")}</p>}
        {twins.map(([a, b]) => <p key={`${a}-${b}`} class="note warn" role="status">{t("duplicate", { a, b })}</p>)}
        {check ? (
          <>
            <dl class="facts">
              <div><dt>{t("aperture")}</dt><dd>{t("unitMm", { n: number((check.aperture ?? 0) * 1000, 1) })}</dd></div>
              <div><dt>{t("aliasing")}</dt><dd>{t("aliasingPair", { closest: hertz(check.aliasing_hz), widest: hertz(check.aliasing_hz_worst) })}</dd></div>
              <div><dt>{t("pairs")}</dt><dd>{t("pairsOf", { n: check.pairs_used ?? 0, all: check.pairs ?? 0 })}</dd></div>
              {known.length > 0 && (
                <div><dt>{t("errorMap")}</dt><dd>{t("errorMean", { mean: `${number(known.reduce((a, b) => a + b, 0) / known.length, 1)}°`, worst: `${number(Math.max(...known), 1)}°` })}</dd></div>
              )}
            </dl>
            {check.flat && <p class="small-text soft">{t("flat")}</p>}
            {check.ambiguous && (twin ? <p class="note warn">{t("ambiguous", { n: check.ambiguous.length, a: where(twin.a), b: where(twin.b) })}</p> : <p class="small-text soft">{t("unambiguous")}</p>)}
          </>
        ) : (
          <p class="soft small-text">{t("noCheck")}</p>
        )}
      </div>
    </section>
  );
}

interface TableProps {
  draft: Draft;
  may: boolean;
  chosen: number | null;
  onChoose: (mic: number | null) => void;
}

function MicTable({ draft, may, chosen, onChoose }: TableProps) {
  const form = draft.form.value;
  const mics = micsOf(form);
  const channels = channelsOf(form, mics.length);
  const [problems, setProblems] = useState<Record<string, string>>({});
  const edit = (mic: number, axis: number, text: string) => {
    const key = `${mic}.${axis}`;
    const parsed = parseTyped({ path: "", key: "", kind: "float" }, text);
    if ("problem" in parsed) return setProblems({ ...problems, [key]: t(`problem_${parsed.problem}`) });
    setProblems(Object.fromEntries(Object.entries(problems).filter(([one]) => one !== key)));
    const position = [...mics[mic]!.position];
    if (position[axis] === parsed.value) return;
    position[axis] = parsed.value as number;
    void draft.edit([{ path: `general.mics[${mic}].mu`, value: position }]);
  };
  return (
    <section class="panel" aria-labelledby="mics-title">
      <header>
        <h2 id="mics-title">{t("mics")}</h2>
        {may && <button class="button small" onClick={() => void draft.edit([{ path: `general.mics[${mics.length}]`, value: { mu: [0, 0, 0] } }])}>{t("addMic")}</button>}
      </header>
      <div class="table-scroll" tabIndex={0} role="group" aria-label={t("mics")}>
        <table class="table mic-table">
          <thead><tr><th>{t("mic")}</th><th>x (m)</th><th>y (m)</th><th>z (m)</th><th>{t("pointing")}</th><th>{t("channel")}</th><th><span class="visually-hidden">{t("remove")}</span></th></tr></thead>
          <tbody>
            {mics.map(({ position, direction }, mic) => {
              const faults = faultsAt(draft.faults.value, `general.mics[${mic}]`, true).concat(faultsAt(draft.faults.value, `general.mics[${mic}]`));
              const problem = [0, 1, 2].map((axis) => problems[`${mic}.${axis}`]).find(Boolean);
              return (
                <tr key={mic} class={chosen === mic ? "chosen" : ""} onClick={() => onChoose(mic)}>
                  <th scope="row">{mic + 1}</th>
                  {["x", "y", "z"].map((name, axis) => (
                    <td key={name}>
                      <input
                        type="text" class="number-input" disabled={!may} spellcheck={false} aria-label={`${t("mic")} ${mic + 1} ${name} (m)`}
                        aria-invalid={problems[`${mic}.${axis}`] !== undefined || faults.length > 0} value={showValue(position[axis])} key={showValue(position[axis])}
                        onFocus={() => onChoose(mic)} onChange={(event) => edit(mic, axis, event.currentTarget.value)}
                      />
                    </td>
                  ))}
                  <td>{`${angle(azimuth(direction[0], direction[1]))} / ${angle(elevation(...direction))}`}</td>
                  <td>{channels[mic]}</td>
                  <td>
                    {may && <button class="button ghost small" aria-label={t("removeMic", { n: mic + 1 })} onClick={(event) => { event.stopPropagation(); onChoose(null); void draft.edit([{ path: `general.mics[${mic}]`, value: null }]); }}>×</button>}
                    {problem && <span class="bad-text small-text" role="alert">{problem}</span>}
                    {faults.map((fault) => <span key={fault.what} class="bad-text small-text" role="alert">{fault.what}</span>)}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </section>
  );
}

function Library({ draft }: { draft: Draft }) {
  const { call } = useStudio();
  const list = useAsked<{ name: string; title?: string }[]>("arrays.list", {});
  const [name, setName] = useState("");
  const load = () => call<{ text: string }>("arrays.get", { name }).then(({ text }) => draft.replace(text), sayError);
  if (!list.value?.length) return null;
  return (
    <section class="panel" aria-labelledby="library-title">
      <header><h2 id="library-title">{t("library")}</h2></header>
      <div class="panel-body row-wrap">
        <select class="grow" value={name} aria-label={t("library")} onChange={(event) => setName(event.currentTarget.value)}>
          <option value="">{t("choose")}</option>
          {list.value.map((one) => <option key={one.name} value={one.name}>{one.title ? `${one.title} (${one.name})` : one.name}</option>)}
        </select>
        <button class="button" disabled={!name} onClick={load}>{t("load")}</button>
      </div>
    </section>
  );
}
