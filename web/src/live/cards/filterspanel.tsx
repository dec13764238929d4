// SPDX-License-Identifier: MIT
import { number } from "../../i18n/i18n";
import { kFilters, type Filters } from "../filters";
import { t } from "../texts";
import { useView } from "../view";

export function FiltersPanel() {
  const view = useView();
  const filters = view.filters.value;
  const set = (change: Partial<Filters>) => {
    view.filters.value = { ...view.filters.value, ...change };
  };
  const usual = JSON.stringify(filters) === JSON.stringify(kFilters);
  const [low, high] = filters.energy;
  return (
    <section class="panel filters" aria-label={t("filters")}>
      <header>
        <h2>{t("filters")}</h2>
        <button class="button ghost small" disabled={usual} onClick={() => { view.filters.value = kFilters; }}>{t("resetFilters")}</button>
      </header>
      <div class="panel-body">
        <div class="filter-checks">
          <label><input type="checkbox" checked={filters.tracks} onChange={(event) => set({ tracks: event.currentTarget.checked })} />{t("filterTracks")}</label>
          <label><input type="checkbox" checked={filters.potentials} onChange={(event) => set({ potentials: event.currentTarget.checked })} />{t("filterPotentials")}</label>
        </div>
        <div class="filter-pair">
          <Slider label={t("energyFrom")} value={low} to={1} step={0.01} change={(value) => set({ energy: [value, Math.max(value, high)] })} />
          <Slider label={t("energyTo")} value={high} to={1} step={0.01} change={(value) => set({ energy: [Math.min(value, low), value] })} />
        </div>
        <div class="ramp" aria-hidden="true" style={{ "--from": `${100 * low}%`, "--to": `${100 * high}%` }} />
        <Slider label={t("activityLeast")} value={filters.activity} to={1} step={0.01} change={(value) => set({ activity: value })} />
        <div class="filter-pair">
          <Slider label={t("regionFrom")} value={filters.region[0]} from={-180} to={180} step={1} unit="°" change={(value) => set({ region: [value, filters.region[1]] })} />
          <Slider label={t("regionTo")} value={filters.region[1]} from={-180} to={180} step={1} unit="°" change={(value) => set({ region: [filters.region[0], value] })} />
        </div>
      </div>
    </section>
  );
}

interface SliderProps {
  label: string;
  value: number;
  from?: number;
  to: number;
  step: number;
  unit?: string;
  change: (value: number) => void;
}

function Slider({ label, value, from = 0, to, step, unit = "", change }: SliderProps) {
  const text = unit ? `${number(value)}${unit}` : number(value, 2);
  return (
    <label class="slider">
      <span>{label}</span>
      <b class="figures" aria-hidden="true">{text}</b>
      <input type="range" min={from} max={to} step={step} value={value} aria-valuetext={text} onInput={(event) => change(Number(event.currentTarget.value))} />
    </label>
  );
}
