// SPDX-License-Identifier: MIT
import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";

import { t } from "./texts";

/** A component whose code is loaded when it is first shown. */
export function lazy<Props extends object>(load: () => Promise<ComponentType<Props>>): ComponentType<Props> {
  let ready: ComponentType<Props> | null = null;
  return function Lazy(props: Props) {
    const [Loaded, setLoaded] = useState<ComponentType<Props> | null>(() => ready);
    const [failed, setFailed] = useState(false);
    useEffect(() => {
      if (Loaded) return;
      load().then(
        (component) => {
          ready = component;
          setLoaded(() => component);
        },
        () => setFailed(true),
      );
    }, []);
    if (failed) {
      return (
        <div class="empty" role="alert">
          <h2>{t("loadFailed")}</h2>
          <p>{t("loadFailedNext")}</p>
          <button class="button primary" onClick={() => location.reload()}>{t("reload")}</button>
        </div>
      );
    }
    return Loaded ? <Loaded {...props} /> : <div class="loading" aria-busy="true" />;
  };
}
