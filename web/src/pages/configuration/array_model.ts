// SPDX-License-Identifier: MIT
// The microphones of a configuration's form, and what `array.check` says of them.
import type { Field, Form } from "../../lib/config_form";
import type { Vec3 } from "../../socket/messages";

export interface ArrayCheck {
  aperture?: number;
  aliasing_hz?: number;
  aliasing_hz_worst?: number;
  pairs?: number;
  pairs_used?: number;
  flat?: boolean;
  ambiguous?: { a: Vec3; b: Vec3; apart?: number }[];
  error_map?: { directions: Vec3[]; degrees: (number | null)[] };
  text?: string;
}

export interface FormMic {
  position: Vec3;
  direction: Vec3;
}

function find(fields: readonly Field[], path: string): Field | null {
  for (const field of fields) {
    if (field.path === path) return field;
    const inner = field.fields && path.startsWith(`${field.path}.`) ? find(field.fields, path) : null;
    if (inner) return inner;
  }
  return null;
}

export function fieldAt(form: Form, path: string): Field | null {
  for (const section of form.sections) {
    const found = find(section.fields, path);
    if (found) return found;
  }
  return null;
}

export function micsOf(form: Form | null): FormMic[] {
  const list = form && fieldAt(form, "general.mics");
  return (list?.items ?? []).map((item) => ({
    position: vector(item.find((field) => field.key === "mu")?.value, [0, 0, 0]),
    direction: vector(item.find((field) => field.key === "direction")?.value, [0, 0, 1]),
  }));
}

/** Channels of the input, from 1, as `mapping.map` says. */
export function channelsOf(form: Form | null, count: number): number[] {
  const map = form && fieldAt(form, "mapping.map")?.value;
  return Array.from({ length: count }, (_, i) => (Array.isArray(map) && map.length > 0 ? Number(map[i] ?? 0) : i + 1));
}

function vector(value: unknown, fallback: Vec3): Vec3 {
  return Array.isArray(value) && value.length >= 3 ? [Number(value[0]), Number(value[1]), Number(value[2])] : fallback;
}
