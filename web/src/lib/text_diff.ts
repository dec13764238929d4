// SPDX-License-Identifier: MIT
// What differs between two texts, line by line: the longest common subsequence of what is between equal ends.

export interface DiffLine {
  kind: "same" | "added" | "removed";
  text: string;
  /** Line numbers from 1, in the old and in the new text. */
  before?: number;
  after?: number;
}

export function diffLines(before: string, after: string): DiffLine[] {
  const a = before.split("\n");
  const b = after.split("\n");
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) ++head;
  let tail = 0;
  while (tail < a.length - head && tail < b.length - head && a.at(-1 - tail) === b.at(-1 - tail)) ++tail;
  const lines: DiffLine[] = [];
  const same = (i: number, j: number) => lines.push({ kind: "same", text: a[i]!, before: i + 1, after: j + 1 });
  for (let i = 0; i < head; ++i) same(i, i);
  middle(a.slice(head, a.length - tail), b.slice(head, b.length - tail), head, lines);
  for (let i = 0; i < tail; ++i) same(a.length - tail + i, b.length - tail + i);
  return lines;
}

function middle(a: string[], b: string[], head: number, lines: DiffLine[]): void {
  const width = b.length + 1;
  const common = new Uint32Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; --i) {
    for (let j = b.length - 1; j >= 0; --j) {
      const skip = Math.max(common[(i + 1) * width + j]!, common[i * width + j + 1]!);
      common[i * width + j] = a[i] === b[j] ? common[(i + 1) * width + j + 1]! + 1 : skip;
    }
  }
  let i = 0;
  let j = 0;
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      lines.push({ kind: "same", text: a[i]!, before: head + ++i, after: head + ++j });
    } else if (i < a.length && (j >= b.length || common[(i + 1) * width + j]! >= common[i * width + j + 1]!)) {
      lines.push({ kind: "removed", text: a[i]!, before: head + ++i });
    } else {
      lines.push({ kind: "added", text: b[j]!, after: head + ++j });
    }
  }
}

/** The same with only `around` lines beside each change; `null` stands for what is left out. */
export function hunks(lines: DiffLine[], around = 2): (DiffLine | null)[] {
  const near = lines.map((_, i) => lines.slice(Math.max(0, i - around), i + around + 1).some((line) => line.kind !== "same"));
  const result: (DiffLine | null)[] = [];
  lines.forEach((line, i) => {
    if (near[i]) result.push(line);
    else if (i === 0 || near[i - 1]) result.push(null);
  });
  return result.every((line) => line === null) ? [] : result;
}
