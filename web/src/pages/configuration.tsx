// SPDX-License-Identifier: MIT
import { t } from "../shell/texts";

export function ConfigurationPage() {
  return <h1 class="page-title">{t("configuration")}</h1>;
}
