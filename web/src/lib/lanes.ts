// SPDX-License-Identifier: MIT

/** Spans put into as few rows as keep them apart; beyond `most` rows the last one takes the rest. */
export function lanes<Span extends { from: number; to: number }>(spans: readonly Span[], most: number): Span[][] {
  const rows: Span[][] = [];
  for (const span of [...spans].sort((a, b) => a.from - b.from)) {
    const free = rows.find((row) => row.at(-1)!.to <= span.from);
    if (free) free.push(span);
    else if (rows.length < most) rows.push([span]);
    else rows.at(-1)!.push(span);
  }
  return rows;
}
