// SPDX-License-Identifier: MIT
import { t } from "../shell/texts";

export function RecordingsPage() {
  return <h1 class="page-title">{t("recordings")}</h1>;
}
