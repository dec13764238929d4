// SPDX-License-Identifier: MIT
// Where a session may come from: the daemon's list, or a file of this computer.
import { useRef, useState } from "preact/hooks";

import { language, number } from "../../i18n/i18n";
import { bytes, clock } from "../../lib/bytes";
import { exportUrl, sessionUrl } from "../../lib/recording_list";
import { kFormats } from "../../lib/session_export";
import { Icon } from "../../shell/icons";
import { sayError } from "../../shell/toast";
import { useStudio } from "../../studio";
import { useAskedList } from "../shared/asked";
import { Confirm } from "../shared/confirm";
import { useMayChange } from "../shared/notes";
import { t as shared } from "../shared/texts";
import { t } from "./texts";

export interface SessionEntry {
  name: string;
  seconds?: number;
  bytes?: number;
  start?: string;
  label?: string;
  audio?: string[];
}

export function FileDrop({ onFile }: { onFile: (file: File) => void }) {
  const input = useRef<HTMLInputElement>(null);
  const [over, setOver] = useState(false);
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setOver(false);
    const file = event.dataTransfer?.files[0];
    if (file) onFile(file);
  };
  return (
    <section class="panel" aria-labelledby="disk-title">
      <header><h2 id="disk-title">{t("fromDisk")}</h2></header>
      <div
        class={`panel-body drop ${over ? "over" : ""}`}
        onDragOver={(event) => { event.preventDefault(); setOver(true); }}
        onDragLeave={() => setOver(false)}
        onDrop={drop}
      >
        <p class="soft">{t(over ? "dropNow" : "drop")}</p>
        <button class="button" onClick={() => input.current!.click()}>{t("choose")}</button>
        <input ref={input} type="file" accept=".mcap" hidden onChange={(event) => { const file = event.currentTarget.files?.[0]; if (file) onFile(file); event.currentTarget.value = ""; }} />
      </div>
    </section>
  );
}

export function SessionList({ onOpen }: { onOpen: (name: string) => void }) {
  const { store, call } = useStudio();
  const list = useAskedList<SessionEntry>("sessions.list", {}, [store.recordingsChanged.value]);
  const may = useMayChange();
  const [deleting, setDeleting] = useState<string | null>(null);
  const sessions = [...(list.value ?? [])].sort((a, b) => (b.start ?? b.name).localeCompare(a.start ?? a.name));
  const answer = (yes: boolean) => {
    if (yes) call("sessions.delete", { names: [deleting] }).then(list.again, sayError);
    setDeleting(null);
  };
  return (
    <section class="panel" aria-labelledby="sessions-title">
      <header><h2 id="sessions-title">{t("sessions")}</h2></header>
      {list.error && !list.value && <p class="panel-body bad-text" role="alert">{t("listFailed", { why: list.error.message })}</p>}
      <ul class="session-list">
        {sessions.map((one) => <Entry key={one.name} entry={one} may={may} onOpen={() => onOpen(one.name)} onDelete={() => setDeleting(one.name)} onRenamed={list.again} />)}
      </ul>
      {list.value && sessions.length === 0 && <NoSessions />}
      {deleting && <Confirm title={t("deleteTitle")} action={t("delete")} danger onAnswer={answer}><p><code>{deleting}</code></p><p class="soft">{t("deleteBody")}</p></Confirm>}
    </section>
  );
}

interface EntryProps {
  entry: SessionEntry;
  may: boolean;
  onOpen: () => void;
  onDelete: () => void;
  onRenamed: () => void;
}

function Entry({ entry, may, onOpen, onDelete, onRenamed }: EntryProps) {
  const { call } = useStudio();
  const [renaming, setRenaming] = useState(false);
  const { name, label, start } = entry;
  const when = start ? new Date(start).toLocaleString(language.value, { dateStyle: "medium", timeStyle: "short" }) : name;
  const title = label || when;
  const facts = [label && when, entry.bytes !== undefined && bytes(entry.bytes, number), (entry.audio?.length ?? 0) > 0 && t("withSound")].filter(Boolean).join(" · ");
  const save = (event: Event) => {
    event.preventDefault();
    const input = (event.currentTarget as HTMLFormElement).elements[0] as HTMLInputElement;
    setRenaming(false);
    call("sessions.rename", { name, label: input.value.trim() }).then(onRenamed, sayError);
  };
  return (
    <li class="session" data-name={name}>
      <button class="button icon-only" aria-label={t("openName", { name: title })} title={t("open")} onClick={onOpen}><Icon name="play" filled /></button>
      <div class="recording-text">
        {renaming ? (
          <form class="rename" onSubmit={save} onKeyDown={(event) => { if (event.key === "Escape") setRenaming(false); }}>
            <input type="text" maxLength={200} defaultValue={label ?? ""} aria-label={t("labelOf", { name })} ref={(input) => input?.focus()} />
            <button class="button small primary" type="submit">{t("save")}</button>
          </form>
        ) : (
          <strong class="recording-title" title={name}>{title}</strong>
        )}
        <span class="recording-facts soft">{facts}</span>
      </div>
      <span class="figures">{clock(entry.seconds ?? 0)}</span>
      <div class="recording-tools">
        {kFormats.map((format) => (
          <a key={format} class="button ghost small" href={exportUrl(name, format)} download aria-label={t("exportAs", { format: format.toUpperCase(), name: title })}>{format.toUpperCase()}</a>
        ))}
        <a class="button ghost small" href={sessionUrl(name)} download={name} aria-label={`${shared("download")}: ${title}`}>{shared("download")}</a>
        {may && <button class="button ghost small" aria-label={`${t("rename")}: ${title}`} onClick={() => setRenaming(true)}>{t("rename")}</button>}
        {may && <button class="button ghost small bad-text" aria-label={`${t("delete")}: ${title}`} onClick={onDelete}>{t("delete")}</button>}
      </div>
    </li>
  );
}

function NoSessions() {
  const { store, call } = useStudio();
  const may = useMayChange();
  const going = store.recording.value.find((one) => one.what === "session");
  if (going) {
    return (
      <div class="empty">
        <h3>{t("recording")}</h3>
        {may && <button class="button" onClick={() => void call("record.stop", { id: going.id }).catch(sayError)}>{t("stop")}</button>}
      </div>
    );
  }
  return (
    <div class="empty">
      <h3>{t("emptyTitle")}</h3>
      <p>{t(store.operator.value ? "emptyNext" : "emptyViewer")}</p>
      {may && (
        <button class="button primary" disabled={store.run.value === null} onClick={() => void call("record.start", { what: "session" }).catch(sayError)}>
          <Icon name="record" />{t("record")}
        </button>
      )}
    </div>
  );
}
