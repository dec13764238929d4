// SPDX-License-Identifier: MIT
import { useEffect, useRef, useState } from "preact/hooks";

import { language, number } from "../../i18n/i18n";
import { bytes, clock } from "../../lib/bytes";
import { recordingUrl, type Recording } from "../../lib/recording_list";
import { Icon } from "../../shell/icons";
import { sayError } from "../../shell/toast";
import { angle } from "../../shell/units";
import { azimuth, elevation } from "../../store/angles";
import { useStudio } from "../../studio";
import { t as shared } from "../shared/texts";
import type { Player } from "./player";
import { t } from "./texts";
import { Waveform } from "./waveform";

interface Props {
  recording: Recording;
  player: Player;
  chosen: boolean;
  may: boolean;
  onChoose: (chosen: boolean) => void;
  onDelete: () => void;
  onRenamed: () => void;
}

export function Row({ recording, player, chosen, may, onChoose, onDelete, onRenamed }: Props) {
  const [renaming, setRenaming] = useState(false);
  const { name, label, transcript } = recording;
  const title = label || titleOf(recording);
  const playing = player.name.value === name && player.playing.value;
  return (
    <li class={`recording ${playing ? "playing" : ""}`} data-name={name}>
      <input type="checkbox" checked={chosen} aria-label={t("select", { name: title })} onChange={(event) => onChoose(event.currentTarget.checked)} />
      <button class="button icon-only play" aria-label={`${shared(playing ? "pause" : "play")}: ${title}`} onClick={() => player.toggle(name)}>
        <Icon name={playing ? "pause" : "play"} filled={!playing} />
      </button>
      <div class="recording-text">
        {renaming ? (
          <Rename recording={recording} onDone={(changed) => { setRenaming(false); if (changed) onRenamed(); }} />
        ) : (
          <strong class="recording-title" title={name}>{title}</strong>
        )}
        <span class="recording-facts soft">{factsOf(recording).map((fact) => <span key={fact}>{fact}</span>)}</span>
      </div>
      <Waveform recording={recording} player={player} />
      <span class="figures recording-length">{clock(recording.seconds ?? 0)}</span>
      <div class="recording-tools">
        <a class="button ghost small" href={recordingUrl(name)} download={name} aria-label={`${shared("download")}: ${title}`}>{shared("download")}</a>
        {may && <button class="button ghost small" aria-label={`${t("rename")}: ${title}`} onClick={() => setRenaming(true)}>{t("rename")}</button>}
        {may && <button class="button ghost small bad-text" aria-label={`${t("deleteOne")}: ${title}`} onClick={onDelete}>{t("deleteOne")}</button>}
      </div>
      {transcript && <blockquote class="transcript"><span class="visually-hidden">{`${t("transcript")}: `}</span>{transcript}</blockquote>}
    </li>
  );
}

function Rename({ recording, onDone }: { recording: Recording; onDone: (changed: boolean) => void }) {
  const { call } = useStudio();
  const input = useRef<HTMLInputElement>(null);
  useEffect(() => input.current?.select(), []);
  const save = (event: Event) => {
    event.preventDefault();
    call("recordings.rename", { name: recording.name, label: input.current!.value.trim() }).then(() => onDone(true), (error) => {
      sayError(error);
      onDone(false);
    });
  };
  return (
    <form class="rename" onSubmit={save} onKeyDown={(event) => { if (event.key === "Escape") onDone(false); }}>
      <input ref={input} type="text" maxLength={200} defaultValue={recording.label ?? ""} placeholder={titleOf(recording)} aria-label={t("renameLabel", { name: recording.name })} />
      <button class="button small primary" type="submit">{t("save")}</button>
      <button class="button small" type="button" onClick={() => onDone(false)}>{shared("cancel")}</button>
    </form>
  );
}

function titleOf({ kind, track, name }: Recording): string {
  if (kind === "raw") return t("raw");
  return track !== undefined ? t("trackN", { n: track }) : name;
}

function factsOf({ start, stream, kind, direction, bytes: size, label, track, name }: Recording): string[] {
  const facts: string[] = [];
  if (label) facts.push(titleOf({ kind, track, name } as Recording));
  if (start) facts.push(new Date(start).toLocaleString(language.value, { dateStyle: "medium", timeStyle: "medium" }));
  if (kind !== "raw" && (stream === "separated" || stream === "postfiltered")) facts.push(t(stream));
  if (direction) facts.push(t("direction", { az: angle(azimuth(direction[0], direction[1])), el: angle(elevation(...direction)) }));
  if (size !== undefined) facts.push(bytes(size, number));
  return facts;
}
