// SPDX-License-Identifier: MIT
// A session from disk as CSV, JSONL and RTTM, made here, for nothing of it is uploaded.
import type { WireTrack } from "../socket/messages";
import { azimuth, elevation } from "../store/angles";
import type { Session } from "./session";

export const kFormats = ["csv", "jsonl", "rttm"] as const;
export type ExportFormat = (typeof kFormats)[number];

const kTypes: Record<ExportFormat, string> = { csv: "text/csv", jsonl: "application/x-ndjson", rttm: "text/plain" };

export function exportSession(session: Session, format: ExportFormat): Blob {
  const make = { csv: toCsv, jsonl: toJsonl, rttm: toRttm }[format];
  return new Blob(make(session), { type: kTypes[format] });
}

const kClasses = ["undefined", "nonspeech", "speech"];

/** One line for each track of each hop. */
export function toCsv(session: Session): string[] {
  const lines = ["seconds,timestamp,slot,id,tag,class,azimuth,elevation,x,y,z,activity,level\n"];
  for (let i = 0; i < session.hops.length; ++i) {
    const hop = session.hops.at(i);
    for (const track of hop.tracks ?? []) lines.push(csvLine(session.hops.seconds(i), hop.t, track));
  }
  return lines;
}

function csvLine(seconds: number, t: number, [slot, id, x, y, z, activity, level, kind, tag]: WireTrack): string {
  const cells = [
    seconds.toFixed(3), t, slot, id, quoted(tag ?? "dynamic"), kClasses[kind ?? 0] ?? "undefined",
    azimuth(x, y).toFixed(2), elevation(x, y, z).toFixed(2), x, y, z, activity, level ?? "",
  ];
  return cells.join(",") + "\n";
}

function quoted(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The hops as they were, one a line, with `seconds` in front. */
export function toJsonl(session: Session): string[] {
  const lines: string[] = [];
  for (let i = 0; i < session.hops.length; ++i) {
    lines.push(JSON.stringify({ seconds: Number(session.hops.seconds(i).toFixed(3)), ...session.hops.at(i) }) + "\n");
  }
  return lines;
}

/** Who spoke when: https://catalog.ldc.upenn.edu/docs/LDC2004T12/RTTM-format-v13.pdf */
export function toRttm(session: Session): string[] {
  const file = session.name.replace(/\.mcap$/, "").replaceAll(/\s/g, "_") || "session";
  return [...session.spans]
    .sort((a, b) => a.from - b.from)
    .map((span) => {
      const speaker = (span.tag ?? `source_${span.id}`).replaceAll(/\s/g, "_");
      return `SPEAKER ${file} 1 ${span.from.toFixed(3)} ${(span.to - span.from).toFixed(3)} <NA> <NA> ${speaker} <NA> <NA>\n`;
    });
}
