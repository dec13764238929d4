// SPDX-License-Identifier: MIT
// The form of a configuration, as `config.form` describes it, and what a user writes into it.

export type Kind = "bool" | "int" | "float" | "string" | "ints" | "strings" | "floats" | "group" | "list";

export interface Field {
  path: string;
  key: string;
  kind: Kind;
  unit?: string;
  min?: number | null;
  max?: number | null;
  min_excluded?: boolean;
  meaning?: string;
  choices?: string[];
  required?: boolean;
  default?: unknown;
  value?: unknown;
  /** It stands in the text. */
  written?: boolean;
  line?: number | null;
  /** Of `floats`: how many. */
  length?: number;
  fields?: Field[];
  items?: Field[][];
  item?: Field[];
}

export interface Section {
  name: string;
  fields: Field[];
}

export interface Form {
  sections: Section[];
}

export interface Fault {
  path?: string;
  line?: number | null;
  severity?: "error" | "warning" | string;
  what: string;
}

export interface Change {
  path: string;
  value: unknown;
}

/** Does the text say something else than what holds without it? */
export function isChanged(field: Field): boolean {
  if (field.kind === "group") return (field.fields ?? []).some(isChanged);
  if (field.kind === "list") return field.written ?? (field.items ?? []).length > 0;
  return (field.written ?? false) && !sameValue(field.value, field.default);
}

export function countChanged(fields: readonly Field[]): number {
  return fields.reduce((sum, field) => {
    if (field.kind === "group") return sum + countChanged(field.fields ?? []);
    return sum + (isChanged(field) ? 1 : 0);
  }, 0);
}

export function sameValue(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** Faults that belong to a field, or, for groups and lists, to something within. */
export function faultsAt(faults: readonly Fault[], path: string, within = false): Fault[] {
  return faults.filter(({ path: at = "" }) => at === path || (within && (at.startsWith(`${path}.`) || at.startsWith(`${path}[`))));
}

/** Faults that no field of the form shows: they stand above it. */
export function homelessFaults(faults: readonly Fault[], form: Form): Fault[] {
  const known = new Set<string>();
  const walk = (fields: readonly Field[]) => {
    for (const field of fields) {
      known.add(field.path);
      walk(field.fields ?? []);
      for (const item of field.items ?? []) walk(item);
    }
  };
  for (const section of form.sections) walk(section.fields);
  return faults.filter((fault) => !fault.path || !known.has(fault.path));
}

/** Fields with `query` in their path or meaning, with the groups around them. */
export function filterFields(fields: readonly Field[], query: string): Field[] {
  const wanted = query.trim().toLowerCase();
  if (!wanted) return [...fields];
  const hit = (field: Field) => `${field.path} ${field.meaning ?? ""}`.toLowerCase().includes(wanted);
  return fields.flatMap((field) => {
    if (hit(field)) return [field];
    if (field.kind !== "group") return [];
    const inner = filterFields(field.fields ?? [], query);
    return inner.length > 0 ? [{ ...field, fields: inner }] : [];
  });
}

export type Parsed = { value: unknown } | { problem: "number" | "whole" | "count" | "range" };

/** What was typed into a field. Lists of numbers are parted by commas or spaces. */
export function parseTyped(field: Field, text: string): Parsed {
  switch (field.kind) {
    case "int":
    case "float":
      return parseNumber(field, text);
    case "ints":
    case "floats":
      return parseNumbers(field, text);
    case "strings":
      return { value: text.split(",").map((one) => one.trim()).filter((one) => one.length > 0) };
    default:
      return { value: text };
  }
}

function parseNumber(field: Field, text: string): Parsed {
  const trimmed = text.trim().replace("\u2212", "-");
  const value = Number(trimmed);
  if (trimmed === "" || !Number.isFinite(value)) return { problem: "number" };
  if ((field.kind === "int" || field.kind === "ints") && !Number.isInteger(value)) return { problem: "whole" };
  const { min, max } = field;
  if (typeof min === "number" && (field.min_excluded ? value <= min : value < min)) return { problem: "range" };
  if (typeof max === "number" && value > max) return { problem: "range" };
  return { value };
}

function parseNumbers(field: Field, text: string): Parsed {
  const words = text.split(/[\s,;]+/).filter((word) => word.length > 0);
  const values: unknown[] = [];
  for (const word of words) {
    const parsed = parseNumber(field, word);
    if ("problem" in parsed) return parsed;
    values.push(parsed.value);
  }
  if (field.kind === "floats" && field.length && values.length !== field.length) return { problem: "count" };
  return { value: values };
}

export function showValue(value: unknown): string {
  if (value === null || value === undefined) return "";
  if (Array.isArray(value)) return value.map(showValue).join(", ");
  if (typeof value === "number") return String(Number(value.toPrecision(7)));
  if (typeof value === "object") return JSON.stringify(value);
  return String(value);
}

/** What a new item of a list begins with: what must be there, or, where nothing must, all that is plain. */
export function newItem(list: Field): Record<string, unknown> {
  const fields = list.item ?? [];
  const required = fields.filter((field) => field.required);
  const plain = fields.filter((field) => ["bool", "int", "float", "string"].includes(field.kind));
  const chosen = required.length > 0 ? required : plain;
  return Object.fromEntries(chosen.map((field) => [field.key, field.default ?? emptyOf(field)]));
}

function emptyOf(field: Field): unknown {
  switch (field.kind) {
    case "bool":
      return false;
    case "int":
    case "float":
      return typeof field.min === "number" && field.min > 0 ? field.min : 0;
    case "floats":
      return new Array<number>(field.length ?? 3).fill(0);
    case "ints":
    case "strings":
    case "list":
      return [];
    default:
      return field.choices?.[0] ?? "";
  }
}

/** "more than 0, at most 1 Hz": what a field may be, in numbers; the words are the caller's. */
export function rangeOf(field: Field): { min: number | null; max: number | null; excluded: boolean } {
  return { min: field.min ?? null, max: field.max ?? null, excluded: field.min_excluded ?? false };
}
