// SPDX-License-Identifier: MIT
import { t } from "../shell/texts";

export function LivePage() {
  return <h1 class="page-title">{t("live")}</h1>;
}
