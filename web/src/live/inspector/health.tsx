// SPDX-License-Identifier: MIT
import { number } from "../../i18n/i18n";
import { linkTo } from "../../shell/router";
import { useStore } from "../../studio";
import { t } from "../texts";

interface Figure {
  name: string;
  value: string;
  bad: boolean;
}

function show(value: number | null | undefined, text: (value: number) => string): string {
  return typeof value === "number" && Number.isFinite(value) ? text(value) : "–";
}

export function HealthStrip() {
  const store = useStore();
  const health = store.health.value;
  const percent = (value: number) => `${number(100 * value, value < 0.1 ? 1 : 0)} %`;
  const milliseconds = (value: number) => number(value / 1000, 1);
  const figures: Figure[] = [
    { name: t("share"), value: show(health?.real_time_share, percent), bad: (health?.real_time_share ?? 0) > 0.9 },
    { name: t("hopTime"), value: `${show(health?.hop_p50_us, milliseconds)} / ${show(health?.hop_p99_us, (us) => `${milliseconds(us)} ms`)}`, bad: false },
    { name: t("drops"), value: show(health?.dropped_hops, number), bad: (health?.dropped_hops ?? 0) > 0 },
    { name: t("overruns"), value: show(health?.overruns, number), bad: (health?.overruns ?? 0) > 0 },
    { name: t("cpu"), value: show(health?.cpu, percent), bad: false },
    { name: t("memory"), value: show(health?.rss_bytes, (bytes) => `${number(bytes / 1e6)} MB`), bad: false },
  ];
  return (
    <section class="panel health-strip" aria-label={t("health")}>
      <header>
        <h2>{t("health")}</h2>
        <a href={linkTo("health")}>{t("details")}</a>
      </header>
      <dl class="panel-body figures">
        {figures.map(({ name, value, bad }) => (
          <div key={name} class={bad ? "bad" : ""}><dt>{name}</dt><dd>{value}</dd></div>
        ))}
      </dl>
    </section>
  );
}
