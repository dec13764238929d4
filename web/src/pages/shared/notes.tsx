// SPDX-License-Identifier: MIT
import { useStore } from "../../studio";
import { t } from "./texts";

/** Says to a viewer that he cannot change anything, before he tries. */
export function ViewerNote() {
  return useStore().operator.value ? null : <p class="note" role="note">{t("viewerOnly")}</p>;
}

/** May this client run commands that change something? */
export function useMayChange(): boolean {
  const store = useStore();
  return store.operator.value && store.connected.value;
}
