// SPDX-License-Identifier: MIT
// The health figures of the last minutes, for small charts.
import type { Health } from "../socket/messages";

export const kKeptSeconds = 300;

export class FigureHistory {
  readonly rows: { at: number; health: Health }[] = [];

  /** `at`: seconds of any clock that does not run backwards. */
  push(at: number, health: Health): void {
    this.rows.push({ at, health });
    while (this.rows.length > 0 && this.rows[0]!.at < at - kKeptSeconds) this.rows.shift();
  }

  clear(): void {
    this.rows.length = 0;
  }

  /** `pick` of each row, as points over seconds before `now`; `null` where it was not said. */
  series(now: number, pick: (health: Health) => number | null | undefined): { ago: number; value: number | null }[] {
    return this.rows.map(({ at, health }) => ({ ago: now - at, value: pick(health) ?? null }));
  }

  /** How much a counter has grown from row to row; a counter that fell began anew. */
  growth(now: number, pick: (health: Health) => number | null | undefined): { ago: number; value: number | null }[] {
    return this.series(now, pick).map((point, i, all) => {
      const before = all[i - 1]?.value;
      if (point.value === null || before === null || before === undefined) return { ...point, value: null };
      return { ...point, value: point.value < before ? point.value : point.value - before };
    });
  }
}
