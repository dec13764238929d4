// SPDX-License-Identifier: MIT
// Angles as the user wants to read them.
import { number } from "../i18n/i18n";
import { stored } from "./stored";

export type AngleUnit = "deg" | "rad";

export const angleUnit = stored<AngleUnit>("angle", "deg", (value) => (value === "rad" ? "rad" : "deg"));

/** `degrees` in the unit of choice, with sign and unit: "+34°", "-0.59 rad". */
export function angle(degrees: number): string {
  const radians = angleUnit.value === "rad";
  const rounded = radians ? Math.round(degrees * (Math.PI / 180) * 100) / 100 : Math.round(degrees);
  const text = number(Math.abs(rounded), radians ? 2 : 0);
  const sign = rounded < 0 ? "\u2212" : rounded > 0 ? "+" : "";
  return radians ? `${sign}${text} rad` : `${sign}${text}°`;
}
