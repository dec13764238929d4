// SPDX-License-Identifier: MIT
import { useEffect, useRef } from "preact/hooks";

import { useStore } from "../../studio";
import { t } from "../texts";

/** The end of the log; it follows new lines as long as its end is in view. */
export function LogTail() {
  const lines = useStore().log.value.slice(-60);
  const box = useRef<HTMLDivElement>(null);
  const atEnd = useRef(true);
  useEffect(() => {
    if (atEnd.current && box.current) box.current.scrollTop = box.current.scrollHeight;
  }, [lines]);
  return (
    <section class="panel log">
      <header><h2>{t("log")}</h2></header>
      <div
        ref={box}
        class="log-lines mono"
        tabIndex={0}
        role="region"
        aria-label={t("log")}
        onScroll={(event) => {
          const { scrollHeight, scrollTop, clientHeight } = event.currentTarget;
          atEnd.current = scrollHeight - scrollTop - clientHeight < 24;
        }}
      >
        {lines.length === 0 && <p class="soft">{t("noLog")}</p>}
        {lines.map((line, k) => (
          <p key={k} class={line.level ?? "info"}>
            {line.at && <time dateTime={line.at}>{line.at.slice(11, 19)}</time>}
            <span>{line.text}</span>
          </p>
        ))}
      </div>
    </section>
  );
}
