// SPDX-License-Identifier: MIT
// An opened session: the views of the Live page, fed by it, above the bar that moves it.
import { useEffect, useMemo } from "preact/hooks";

import { language } from "../../i18n/i18n";
import { exportUrl } from "../../lib/recording_list";
import { exportSession, kFormats } from "../../lib/session_export";
import type { Session } from "../../lib/session";
import { LiveView } from "../../live/liveview";
import { StudioContext } from "../../studio";
import { saveFile } from "../shared/save_file";
import { Playback } from "./playback";
import { replayStudio } from "./replay_studio";
import { t } from "./texts";
import { Transport } from "./transport";

interface Props {
  session: Session;
  /** Where the daemon makes the exports; a file from disk has them made here. */
  onDaemon: boolean;
  onClose: () => void;
}

export function Stage({ session, onDaemon, onClose }: Props) {
  const { studio, playback } = useMemo(() => {
    const { studio, feed } = replayStudio();
    return { studio, playback: new Playback(session, feed) };
  }, [session]);
  useEffect(() => () => playback.close(), [playback]);
  const first = session.parts[0]?.run;
  const facts = [
    t("recordedAt", { when: new Date(session.start).toLocaleString(language.value, { dateStyle: "medium", timeStyle: "medium" }) }),
    first?.name,
    session.parts.length > 1 && t("parts", { n: session.parts.length }),
  ].filter(Boolean).join(" · ");
  return (
    <>
      <div class="row-wrap stage-head">
        <div class="recording-text">
          <h2 class="recording-title">{session.name}</h2>
          <span class="soft small-text">{facts}</span>
        </div>
        <span class="row-wrap" role="group" aria-label={t("export")}>
          {kFormats.map((format) => onDaemon ? (
            <a key={format} class="button small" href={exportUrl(session.name, format)} download>{format.toUpperCase()}</a>
          ) : (
            <button key={format} class="button small" onClick={() => saveFile(exportSession(session, format), `${session.name.replace(/\.mcap$/, "")}.${format}`)}>{format.toUpperCase()}</button>
          ))}
        </span>
        <button class="button small" onClick={onClose}>{t("close")}</button>
      </div>
      {session.fault && <p class="note warn" role="status">{t(`fault_${session.fault}`, { name: session.name })}</p>}
      {session.unread > 0 && <p class="note warn" role="status">{t("unread", { n: session.unread })}</p>}
      <StudioContext.Provider value={studio}>
        <LiveView replay />
      </StudioContext.Provider>
      <Transport playback={playback} session={session} />
    </>
  );
}
