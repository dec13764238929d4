// SPDX-License-Identifier: MIT
// Every figure that the engine says of itself, now and over the last minutes.
import { number } from "../../i18n/i18n";
import { bytes } from "../../lib/bytes";
import type { FigureHistory } from "../../lib/figure_history";
import type { Health } from "../../socket/messages";
import { Canvas, type Pen } from "../shared/canvas";
import { t } from "./texts";

type Key = Parameters<typeof t>[0];

interface Figure {
  name: Key;
  pick: (health: Health) => number | null | undefined;
  show: (value: number) => string;
  /** Above it something is wrong. */
  limit?: number;
  /** A counter: shown as what it grew by. */
  counts?: boolean;
}

const us = (value: number) => (value >= 10000 ? t("ms", { n: number(value / 1000, 1) }) : t("us", { n: number(value) }));
const percent = (value: number) => t("percent", { n: number(value * 100, value < 0.1 ? 1 : 0) });
const count = (value: number) => number(value);

const kFigures: Figure[] = [
  { name: "real_time", pick: (h) => h.real_time_share, show: percent, limit: 1 },
  { name: "hop_p50", pick: (h) => h.hop_p50_us, show: us },
  { name: "hop_p99", pick: (h) => h.hop_p99_us, show: us },
  { name: "hop_max", pick: (h) => h.hop_max_us, show: us },
  { name: "latency", pick: (h) => h.latency, show: (value) => t("ms", { n: number(value * 1000, 1) }) },
  { name: "cpu", pick: (h) => h.cpu, show: percent },
  { name: "memory", pick: (h) => h.rss_bytes, show: (value) => bytes(value, number) },
  { name: "temperature", pick: (h) => h.temperature, show: (value) => t("degrees", { n: number(value, 1) }), limit: 85 },
  { name: "hops", pick: (h) => h.hops, show: count },
  { name: "dropped_hops", pick: (h) => h.dropped_hops, show: count, limit: 0, counts: true },
  { name: "overruns", pick: (h) => h.overruns, show: count, limit: 0, counts: true },
  { name: "lost_frames", pick: (h) => h.lost_frames, show: count, limit: 0, counts: true },
  { name: "lost_records", pick: (h) => h.lost_records, show: count, limit: 0, counts: true },
  { name: "clipped", pick: (h) => h.clipped_samples, show: count, limit: 0, counts: true },
  { name: "clients", pick: (h) => h.clients, show: count },
  { name: "client_dropped", pick: (h) => h.client_dropped, show: count, limit: 0, counts: true },
];

export function Figures({ health, history, now }: { health: Health; history: FigureHistory; now: number }) {
  const known = kFigures.filter((figure) => typeof figure.pick(health) === "number");
  return (
    <ul class="figure-grid">
      {known.map((figure) => <Tile key={figure.name} figure={figure} health={health} history={history} now={now} />)}
    </ul>
  );
}

function Tile({ figure, health, history, now }: { figure: Figure; health: Health; history: FigureHistory; now: number }) {
  const value = figure.pick(health)!;
  const bad = figure.limit !== undefined && value > figure.limit;
  const points = figure.counts ? history.growth(now, figure.pick) : history.series(now, figure.pick);
  const values = points.map((point) => point.value).filter((one): one is number => one !== null);
  const trend = values.length > 1 ? t("trend", { name: t(figure.name), low: figure.show(Math.min(...values)), high: figure.show(Math.max(...values)) }) : "";
  return (
    <li class={`figure ${bad ? "bad" : ""}`}>
      <span class="figure-name">{t(figure.name)}</span>
      <strong class="figures figure-value">{figure.show(value)}</strong>
      <Canvas class="spark" role="img" aria-label={trend || t(figure.name)} draw={(pen) => drawSpark(pen, points, bad)} when={[now]} />
      {bad && figure.name === "real_time" && <span class="bad-text small-text" role="alert">{t("bad_real_time")}</span>}
    </li>
  );
}

function drawSpark({ ctx, width, height, color }: Pen, points: { ago: number; value: number | null }[], bad: boolean): void {
  const values = points.map((point) => point.value).filter((one): one is number => one !== null);
  if (values.length < 2) return;
  const high = Math.max(...values);
  const low = Math.min(0, ...values);
  // What there is fills the width, until it is five minutes.
  const longest = Math.max(1, ...points.map((point) => point.ago));
  const x = (ago: number) => width - 1 - (ago / longest) * (width - 2);
  const y = (value: number) => height - 2 - ((value - low) / (high - low || 1)) * (height - 4);
  ctx.strokeStyle = color(bad ? "bad" : "accent");
  ctx.lineWidth = 1.5;
  ctx.lineJoin = "round";
  ctx.beginPath();
  let pen = false;
  for (const { ago, value } of points) {
    if (value !== null) ctx[pen ? "lineTo" : "moveTo"](x(ago), y(value));
    pen = value !== null;
  }
  ctx.stroke();
}

/** Those that this page has a word for; a newer daemon may have more. */
const kStages = new Set(["transform", "noise", "localization", "tracking", "separation", "synthesis", "classification", "post_filter"]);

export function Stages({ stages }: { stages: [string, number][] }) {
  const all = stages.reduce((sum, [, time]) => sum + time, 0);
  if (stages.length === 0) return null;
  return (
    <section class="panel" aria-labelledby="stages-title">
      <header><h2 id="stages-title">{t("stages")}</h2></header>
      <table class="table stages">
        <thead><tr><th>{t("stage")}</th><th class="number">{t("microseconds")}</th><th>{t("share")}</th></tr></thead>
        <tbody>
          {stages.map(([name, time]) => (
            <tr key={name}>
              <th scope="row">{kStages.has(name) ? t(`stage_${name}` as Key) : name}</th>
              <td class="number">{number(time, time < 10 ? 1 : 0)}</td>
              <td><span class="share"><span style={{ width: `${(time / (all || 1)) * 100}%` }} /></span>{percent(time / (all || 1))}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
