// SPDX-License-Identifier: MIT
// The answer of the daemon to a question that is asked again when something changes.
import { useCallback, useEffect, useRef, useState } from "preact/hooks";

import { useStudio } from "../../studio";

export interface Asked<T> {
  value: T | null;
  error: Error | null;
  loading: boolean;
  again: () => void;
}

/** The same for a list; a daemon that answers something else has none to show. */
export function useAskedList<T>(method: string, params: object, when: readonly unknown[] = []): Asked<T[]> {
  const asked = useAsked<T[]>(method, params, when);
  return asked.value === null || Array.isArray(asked.value) ? asked : { ...asked, value: [] };
}

/** Asks when connected, whenever `when` changes, and on `again()`; an older answer never overtakes a newer one. */
export function useAsked<T>(method: string, params: object, when: readonly unknown[] = []): Asked<T> {
  const { store, call } = useStudio();
  const [answer, setAnswer] = useState<{ value: T | null; error: Error | null }>({ value: null, error: null });
  const [loading, setLoading] = useState(true);
  const turn = useRef(0);
  const connected = store.connected.value;
  const again = useCallback(() => {
    const mine = ++turn.current;
    setLoading(true);
    call<T>(method, params).then(
      (value) => {
        if (mine === turn.current) setAnswer({ value, error: null });
      },
      (error: Error) => {
        if (mine === turn.current) setAnswer((before) => ({ value: before.value, error }));
      },
    ).finally(() => {
      if (mine === turn.current) setLoading(false);
    });
  }, [method, JSON.stringify(params)]);
  useEffect(() => {
    if (connected) again();
    return () => {
      ++turn.current;
    };
  }, [connected, again, ...when]);
  return { ...answer, loading, again };
}
