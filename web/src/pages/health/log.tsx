// SPDX-License-Identifier: MIT
import { useEffect, useRef, useState } from "preact/hooks";

import { language } from "../../i18n/i18n";
import { say } from "../../shell/toast";
import type { LogLine } from "../../socket/messages";
import { useStore } from "../../studio";
import { t } from "./texts";

type Least = "" | "warning" | "error";

const kBad = ["error", "fatal", "critical"];

function passes(line: LogLine, words: string, least: Least): boolean {
  const level = line.level ?? "info";
  if (least === "error" && !kBad.includes(level)) return false;
  if (least === "warning" && !kBad.includes(level) && !level.startsWith("warn")) return false;
  return line.text.toLowerCase().includes(words.trim().toLowerCase());
}

/** The newest lines of the daemon's log; stays at the end unless one scrolls up. */
export function Log() {
  const all = useStore().log.value;
  const [words, setWords] = useState("");
  const [least, setLeast] = useState<Least>("");
  const list = useRef<HTMLDivElement>(null);
  const atEnd = useRef(true);
  const lines = all.filter((line) => passes(line, words, least));
  useEffect(() => {
    if (atEnd.current && list.current) list.current.scrollTop = list.current.scrollHeight;
  }, [lines.length, all]);
  const copy = async () => {
    const text = lines.map((line) => `${line.at ?? ""} ${line.level ?? ""} ${line.text}`).join("\n");
    try {
      await navigator.clipboard.writeText(text);
      say(t("copied"));
    } catch {
      getSelection()?.selectAllChildren(list.current!);
      say(t("copyFailed"));
    }
  };
  return (
    <section class="panel" aria-labelledby="log-title">
      <header>
        <h2 id="log-title">{t("log")}</h2>
        <span class="soft small-text">{t("lines", { n: lines.length })}</span>
        <button class="button small" disabled={lines.length === 0} onClick={() => void copy()}>{t("copy")}</button>
      </header>
      <div class="panel-body stack">
        <div class="row-wrap" role="search">
          <input type="search" class="grow" value={words} placeholder={t("filter")} aria-label={t("filter")} onInput={(event) => setWords(event.currentTarget.value)} />
          <label class="inline-field">
            <span>{t("level")}</span>
            <select value={least} onChange={(event) => setLeast(event.currentTarget.value as Least)}>
              <option value="">{t("levelAll")}</option>
              <option value="warning">{t("levelWarning")}</option>
              <option value="error">{t("levelError")}</option>
            </select>
          </label>
        </div>
        {lines.length === 0 ? (
          <p class="soft">{t(all.length === 0 ? "noLog" : "noLogMatch")}</p>
        ) : (
          <div
            ref={list} class="log-lines" tabIndex={0} role="group" aria-label={t("log")}
            onScroll={(event) => { const box = event.currentTarget; atEnd.current = box.scrollHeight - box.scrollTop - box.clientHeight < 8; }}
          >
            <ol>
              {lines.map((line, i) => (
                <li key={i} class={kBad.includes(line.level ?? "") ? "bad-text" : line.level?.startsWith("warn") ? "warn-text" : ""}>
                  <time class="soft">{line.at ? new Date(line.at).toLocaleTimeString(language.value) : ""}</time>
                  <span class="log-level">{line.level ?? ""}</span>
                  <span>{line.text}</span>
                </li>
              ))}
            </ol>
          </div>
        )}
      </div>
    </section>
  );
}
