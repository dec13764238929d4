// SPDX-License-Identifier: MIT
import { t } from "../shell/texts";

export function ReplayPage() {
  return <h1 class="page-title">{t("replay")}</h1>;
}
