// SPDX-License-Identifier: MIT
// What was recorded as a session, seen and heard again.
import { useEffect, useRef, useState } from "preact/hooks";

import { sessionUrl } from "../lib/recording_list";
import { readSession, type Session } from "../lib/session";
import { place, replaceQuery } from "../shell/router";
import { useStore } from "../studio";
import { FileDrop, SessionList } from "./replay/sources";
import { Stage } from "./replay/stage";
import { t } from "./replay/texts";
import { ViewerNote } from "./shared/notes";

type State =
  | { what: "choosing"; problem?: string }
  | { what: "loading"; name: string; share: number }
  | { what: "open"; session: Session; onDaemon: boolean };

export function ReplayPage() {
  const store = useStore();
  const [state, setState] = useState<State>({ what: "choosing" });
  const turn = useRef(0);
  const opened = useRef("");

  const show = async (name: string, onDaemon: boolean, file: () => Promise<Blob>) => {
    const mine = ++turn.current;
    const progress = (share: number) => {
      if (mine === turn.current) setState((now) => (now.what === "loading" && share - now.share < 0.02 ? now : { what: "loading", name, share }));
    };
    setState({ what: "loading", name, share: 0 });
    let next: State;
    try {
      const session = await readSession(name, await file(), progress);
      const problem = session.fault === "not_mcap" || session.fault === "compressed" ? t(`fault_${session.fault}`, { name }) : t("noHops", { name });
      next = session.hops.length > 0 ? { what: "open", session, onDaemon } : { what: "choosing", problem };
    } catch (error) {
      next = { what: "choosing", problem: t("failedFetch", { name, why: error instanceof Error ? error.message : String(error) }) };
    }
    if (mine === turn.current) setState(next);
  };
  const openName = (name: string) => {
    opened.current = name;
    replaceQuery(new URLSearchParams({ session: name }));
    void show(name, true, async () => {
      const answer = await fetch(sessionUrl(name));
      if (!answer.ok) throw new Error((await answer.text()).trim() || answer.statusText);
      return answer.blob();
    });
  };
  const close = () => {
    ++turn.current;
    opened.current = "";
    replaceQuery(new URLSearchParams());
    setState({ what: "choosing" });
  };

  const wanted = place.value.query.get("session");
  useEffect(() => {
    if (wanted && wanted !== opened.current) openName(wanted);
  }, [wanted]);
  useEffect(() => () => {
    ++turn.current;
  }, []);

  return (
    <div class={`page ${state.what === "open" ? "wide" : ""}`}>
      <h1 class={state.what === "open" ? "visually-hidden" : "page-title"}>{t("title")}</h1>
      {state.what === "open" && <Stage session={state.session} onDaemon={state.onDaemon} onClose={close} />}
      {state.what === "loading" && (
        <div class="empty" role="status">
          <h2>{t("loading", { name: state.name, n: Math.round(state.share * 100) })}</h2>
          <progress value={state.share} aria-label={state.name} />
        </div>
      )}
      {state.what === "choosing" && (
        <>
          {state.problem && <p class="note bad" role="alert">{state.problem}</p>}
          <ViewerNote />
          {store.can("sessions") && <SessionList onOpen={openName} />}
          <FileDrop onFile={(file) => void show(file.name, false, async () => file)} />
        </>
      )}
    </div>
  );
}
