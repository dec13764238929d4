// SPDX-License-Identifier: MIT
import { useState } from "preact/hooks";

import { kShapes, makeArray, type Shape, type Template } from "../../lib/array_templates";
import { say } from "../../shell/toast";
import type { Draft } from "./draft";
import { t } from "./texts";

const kSizeNames: Record<Shape, "radius" | "spacing" | "edge"> = { circular: "radius", linear: "spacing", rectangular: "spacing", tetrahedron: "edge" };

/** Microphones in one of the usual shapes, put into the draft. */
export function Templates({ draft }: { draft: Draft }) {
  const [template, setTemplate] = useState<Template>({ shape: "circular", count: 6, rows: 2, size: 0.045 });
  const set = (change: Partial<Template>) => setTemplate({ ...template, ...change });
  const place = async () => {
    const mics = makeArray(template).map(({ position, direction }) => ({ mu: position, direction }));
    await draft.edit([{ path: "general.mics", value: mics }]);
    say(t("placed"));
  };
  const whole = (text: string, fallback: number) => Math.min(256, Math.max(1, Math.round(Number(text)) || fallback));
  return (
    <section class="panel" aria-labelledby="templates-title">
      <header><h2 id="templates-title">{t("templates")}</h2></header>
      <div class="panel-body row-wrap">
        <label class="inline-field">
          <span>{t("shape")}</span>
          <select value={template.shape} onChange={(event) => set({ shape: event.currentTarget.value as Shape })}>
            {kShapes.map((shape) => <option key={shape} value={shape}>{t(`shape_${shape}`)}</option>)}
          </select>
        </label>
        {template.shape !== "tetrahedron" && (
          <label class="inline-field">
            <span>{t(template.shape === "rectangular" ? "columns" : "count")}</span>
            <input type="number" min={1} max={256} value={template.count} onChange={(event) => set({ count: whole(event.currentTarget.value, template.count) })} />
          </label>
        )}
        {template.shape === "rectangular" && (
          <label class="inline-field">
            <span>{t("rows")}</span>
            <input type="number" min={1} max={256} value={template.rows} onChange={(event) => set({ rows: whole(event.currentTarget.value, template.rows) })} />
          </label>
        )}
        <label class="inline-field">
          <span>{t(kSizeNames[template.shape])}</span>
          <input type="number" min={1} step="any" value={Math.round(template.size * 1e5) / 100} onChange={(event) => set({ size: Math.max(0.1, Number(event.currentTarget.value) || template.size * 1000) / 1000 })} />
        </label>
        <button class="button" onClick={() => void place()}>{t("place")}</button>
      </div>
    </section>
  );
}
