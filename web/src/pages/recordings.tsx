// SPDX-License-Identifier: MIT
// What was recorded: hear it, take it away, name it, throw it away; and what is being recorded now.
import { useEffect, useMemo, useState } from "preact/hooks";

import { number } from "../i18n/i18n";
import { bytes } from "../lib/bytes";
import { filterRecordings, kNoFilter, zipUrl, type Filter, type Recording } from "../lib/recording_list";
import { linkTo } from "../shell/router";
import { say, sayError } from "../shell/toast";
import { useStudio } from "../studio";
import { Deletion } from "./recordings/deletion";
import { Now } from "./recordings/now";
import { Player } from "./recordings/player";
import { Row } from "./recordings/row";
import { t } from "./recordings/texts";
import { useAskedList } from "./shared/asked";
import { Confirm } from "./shared/confirm";
import { useMayChange, ViewerNote } from "./shared/notes";
import { t as shared } from "./shared/texts";

export function RecordingsPage() {
  const { store, call } = useStudio();
  const list = useAskedList<Recording>("recordings.list", {}, [store.recordingsChanged.value]);
  const player = useMemo(() => new Player((name) => say(t("playFailed", { name }), "error")), []);
  const deletion = useMemo(() => new Deletion((names) => {
    call("recordings.delete", { names }).catch(sayError).finally(() => {
      list.again();
      deletion.done(names);
    });
  }), []);
  const [filter, setFilter] = useState<Filter>(kNoFilter);
  const [chosen, setChosen] = useState<ReadonlySet<string>>(new Set());
  const [asking, setAsking] = useState<string[] | null>(null);
  const may = useMayChange();

  useEffect(() => {
    const leave = () => deletion.flush();
    addEventListener("pagehide", leave);
    return () => {
      removeEventListener("pagehide", leave);
      leave();
      player.close();
    };
  }, []);

  const all = (list.value ?? []).filter((one) => !deletion.names.value.includes(one.name));
  const shown = filterRecordings(all, filter);
  const picked = shown.filter((one) => chosen.has(one.name)).map((one) => one.name);
  const choose = (names: string[], on: boolean) => {
    const next = new Set(chosen);
    for (const name of names) on ? next.add(name) : next.delete(name);
    setChosen(next);
  };
  const answer = (yes: boolean) => {
    if (yes && asking) {
      if (player.name.value && asking.includes(player.name.value)) player.close();
      deletion.begin(asking);
      choose(asking, false);
    }
    setAsking(null);
  };

  return (
    <div class="page">
      <h1 class="page-title">{t("title")}</h1>
      <ViewerNote />
      <Now />
      <section class="panel" aria-labelledby="list-title">
        <header>
          <h2 id="list-title">{all.length > 0 ? t("total", { n: all.length, size: bytes(all.reduce((sum, one) => sum + (one.bytes ?? 0), 0), number) }) : t("title")}</h2>
          {all.length > 0 && <a class="button small" href={zipUrl([])} download>{t("zipAll")}</a>}
          {store.can("sessions") && <a class="button small ghost" href={linkTo("replay")}>{t("toReplay")}</a>}
        </header>
        {all.length > 0 && <Filters filter={filter} onChange={setFilter} />}
        {shown.length > 0 && (
          <div class="list-tools">
            <label class="menu-check">
              <input type="checkbox" checked={picked.length === shown.length} onChange={(event) => choose(shown.map((one) => one.name), event.currentTarget.checked)} />
              <span>{picked.length > 0 ? t("chosen", { n: picked.length }) : t("selectAll")}</span>
            </label>
            {picked.length > 0 && <a class="button small" href={zipUrl(picked)} download>{t("zipChosen")}</a>}
            {picked.length > 0 && may && <button class="button small danger" onClick={() => setAsking(picked)}>{t("deleteChosen")}</button>}
            {shown.length < all.length && <span class="soft small-text">{t("countOf", { n: shown.length, all: all.length })}</span>}
          </div>
        )}
        <ul class="recording-list">
          {shown.map((one) => (
            <Row
              key={one.name} recording={one} player={player} may={may} chosen={chosen.has(one.name)}
              onChoose={(on) => choose([one.name], on)} onDelete={() => setAsking([one.name])} onRenamed={list.again}
            />
          ))}
        </ul>
        <Empty loading={list.loading && !list.value} error={list.error} all={all.length} shown={shown.length} onRetry={list.again} onClear={() => setFilter(kNoFilter)} />
      </section>
      {asking && (
        <Confirm title={asking.length === 1 ? t("deleteTitleOne") : t("deleteTitle", { n: asking.length })} action={t("deleteOne")} danger onAnswer={answer}>
          <ul class="confirm-names">{asking.slice(0, 6).map((name) => <li key={name}>{name}</li>)}{asking.length > 6 && <li>{`+ ${asking.length - 6}`}</li>}</ul>
          <p class="soft">{t("deleteBody")}</p>
        </Confirm>
      )}
      {deletion.names.value.length > 0 && (
        <div class="undo-bar" role="status">
          <span>{t("deleted", { n: deletion.names.value.length })}</span>
          <button class="button small" onClick={() => deletion.undo()}>{shared("undo")}</button>
        </div>
      )}
    </div>
  );
}

function Filters({ filter, onChange }: { filter: Filter; onChange: (filter: Filter) => void }) {
  return (
    <div class="list-filters" role="search">
      <input type="search" value={filter.text} placeholder={t("filter")} aria-label={t("filter")} onInput={(event) => onChange({ ...filter, text: event.currentTarget.value })} />
      <label class="inline-field">
        <span>{t("kind")}</span>
        <select value={filter.kind} onChange={(event) => onChange({ ...filter, kind: event.currentTarget.value as Filter["kind"] })}>
          <option value="">{t("any")}</option>
          <option value="track">{t("track")}</option>
          <option value="raw">{t("raw")}</option>
        </select>
      </label>
      <label class="inline-field">
        <span>{t("stream")}</span>
        <select value={filter.stream} onChange={(event) => onChange({ ...filter, stream: event.currentTarget.value as Filter["stream"] })}>
          <option value="">{t("any")}</option>
          <option value="separated">{t("separated")}</option>
          <option value="postfiltered">{t("postfiltered")}</option>
        </select>
      </label>
    </div>
  );
}

interface EmptyProps {
  loading: boolean;
  error: Error | null;
  all: number;
  shown: number;
  onRetry: () => void;
  onClear: () => void;
}

function Empty({ loading, error, all, shown, onRetry, onClear }: EmptyProps) {
  const { store } = useStudio();
  if (shown > 0) return null;
  if (error && all === 0) {
    return (
      <div class="empty" role="alert">
        <h3>{t("failed", { why: error.message })}</h3>
        <button class="button" onClick={onRetry}>{t("tryAgain")}</button>
      </div>
    );
  }
  if (loading) return <div class="empty"><p>{t("loading")}</p></div>;
  if (all > 0) {
    return (
      <div class="empty">
        <h3>{t("noneMatch")}</h3>
        <button class="button" onClick={onClear}>{t("clearFilter")}</button>
      </div>
    );
  }
  return (
    <div class="empty">
      <h3>{t("emptyTitle")}</h3>
      <p>{t(store.operator.value ? "emptyNext" : "emptyViewer")}</p>
    </div>
  );
}
