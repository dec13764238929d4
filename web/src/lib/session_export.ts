// SPDX-License-Identifier: MIT
// A session from disk as CSV, JSONL and RTTM, made here, for nothing of it is uploaded: the columns are those of the daemon's exports.
import type { WireTrack } from "../socket/messages";
import { azimuth, elevation } from "../store/angles";
import type { Session } from "./session";

export const kFormats = ["csv", "jsonl", "rttm"] as const;
export type ExportFormat = (typeof kFormats)[number];

const kTypes: Record<ExportFormat, string> = { csv: "text/csv", jsonl: "application/x-ndjson", rttm: "text/plain" };

/** A voice talks where it is this active; shorter pauses (seconds) are within its talk. */
const kActive = 0.5;
const kPause = 0.5;

export function exportSession(session: Session, format: ExportFormat): Blob {
  const make = { csv: toCsv, jsonl: toJsonl, rttm: toRttm }[format];
  return new Blob(make(session), { type: kTypes[format] });
}

function utcOf(session: Session, seconds: number): string {
  return new Date(session.start + Math.round(seconds * 1000)).toISOString();
}

function classOf(kind: number | undefined): string {
  return kind === 2 ? "speech" : kind === 1 ? "nonspeech" : "";
}

/** One line for each track of each hop. */
export function toCsv(session: Session): string[] {
  const lines = ["timeStamp,time,utc,slot,id,tag,x,y,z,azimuth,elevation,activity,level,class\n"];
  for (let i = 0; i < session.hops.length; ++i) {
    const hop = session.hops.at(i);
    const seconds = session.hops.seconds(i);
    const head = `${hop.t},${seconds.toFixed(3)},${utcOf(session, seconds)}`;
    for (const track of hop.tracks ?? []) lines.push(`${head},${cells(track)}\n`);
  }
  return lines;
}

function cells([slot, id, x, y, z, activity, level, kind, tag]: WireTrack): string {
  return [
    slot, id, quoted(tag ?? "dynamic"), x.toFixed(4), y.toFixed(4), z.toFixed(4), azimuth(x, y).toFixed(2), elevation(x, y, z).toFixed(2),
    activity.toFixed(3), typeof level === "number" ? level.toFixed(1) : "", classOf(kind),
  ].join(",");
}

function quoted(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** One object a line for each hop. */
export function toJsonl(session: Session): string[] {
  const lines: string[] = [];
  for (let i = 0; i < session.hops.length; ++i) {
    const hop = session.hops.at(i);
    const seconds = session.hops.seconds(i);
    const src = (hop.tracks ?? []).map(([slot, id, x, y, z, activity, , kind, tag]) => ({
      slot, id, tag: tag ?? "dynamic", x, y, z, azimuth: rounded(azimuth(x, y)), elevation: rounded(elevation(x, y, z)), activity,
      ...(classOf(kind) ? { class: classOf(kind) } : {}),
    }));
    lines.push(JSON.stringify({ timeStamp: hop.t, time: rounded(seconds), utc: utcOf(session, seconds), src }) + "\n");
  }
  return lines;
}

function rounded(value: number): number {
  return Math.round(value * 1000) / 1000;
}

interface Talk {
  speaker: string;
  begin: number;
  end: number;
}

/** Who talked when: https://catalog.ldc.upenn.edu/docs/LDC2004T12/RTTM-format-v13.pdf */
export function toRttm(session: Session): string[] {
  const name = session.name.replace(/\.mcap$/, "").replaceAll(/\s/g, "_") || "session";
  return talks(session)
    .sort((a, b) => a.begin - b.begin)
    .map(({ speaker, begin, end }) => `SPEAKER ${name} 1 ${begin.toFixed(3)} ${(end - begin).toFixed(3)} <NA> <NA> ${speaker} <NA> <NA>\n`);
}

function talks(session: Session): Talk[] {
  const done: Talk[] = [];
  const open = new Map<string, Talk>();
  let part = -1;
  for (let i = 0; i < session.hops.length; ++i) {
    if (session.parts[part + 1]?.firstHop === i) ++part;
    const { run } = session.parts[part]!;
    const begin = session.hops.seconds(i);
    for (const [, id, , , , activity, , kind] of session.hops.at(i).tracks ?? []) {
      if (activity < kActive || kind === 1) continue;
      // Ids begin anew with each run.
      const speaker = `${part > 0 ? `run${part + 1}_` : ""}source_${id}`;
      let talk = open.get(speaker);
      if (!talk || begin - talk.end > kPause) {
        talk = { speaker, begin, end: begin };
        open.set(speaker, talk);
        done.push(talk);
      }
      talk.end = begin + run.hop / run.rate;
    }
  }
  return done;
}
