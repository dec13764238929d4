// SPDX-License-Identifier: MIT
// What stands in the way of a true picture, and what to do about it.
import { useStore } from "../studio";
import { t } from "./texts";

export function Banners({ retry }: { retry: () => void }) {
  const store = useStore();
  const stranger = store.stranger.value;
  const engine = store.engine.value;
  return (
    <>
      {store.link.value === "offline" && (
        <div class="banner bad" role="alert">
          <strong>{t("offlineTitle")}</strong>
          <span>{t("offlineNext", { n: store.attempts.value })}</span>
          <button class="button small" onClick={retry}>{t("retry")}</button>
        </div>
      )}
      {stranger && (
        <div class="banner warn" role="status">
          <span>{t(stranger, { n: store.hello.value?.protocol ?? "?" })}</span>
        </div>
      )}
      {engine?.state === "failed" && store.connected.value && (
        <div class="banner bad" role="alert">
          <strong>{t("failed")}</strong>
          <span>{engine.what}</span>
        </div>
      )}
    </>
  );
}
