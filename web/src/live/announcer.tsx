// SPDX-License-Identifier: MIT
// Tells screen readers who came and who went: one sentence every two seconds at most.
import { useEffect, useState } from "preact/hooks";

import { announcing } from "../shell/announce";
import { angle } from "../shell/units";
import { useStore } from "../studio";
import { t } from "./texts";

const kQuiet = 2000;

export function Announcer() {
  const store = useStore();
  const [words, setWords] = useState("");
  useEffect(() => {
    let known = new Set<number>(store.tracks.live.keys());
    const timer = setInterval(() => {
      const now = store.liveTracks();
      const ids = new Set(now.map((track) => track.id));
      const came = now.filter((track) => !known.has(track.id));
      const went = [...known].filter((id) => !ids.has(id));
      known = ids;
      if (!announcing.value || came.length + went.length === 0) return;
      if (came.length + went.length > 2) return setWords(t("manyAppeared", { n: came.length, m: went.length }));
      setWords([...came.map((track) => t("appeared", { id: track.id, where: angle(track.az) })), ...went.map((id) => t("disappeared", { id }))].join(". "));
    }, kQuiet);
    return () => clearInterval(timer);
  }, []);
  return <div class="visually-hidden" role="status" aria-live="polite" data-announcer>{words}</div>;
}
