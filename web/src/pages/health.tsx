// SPDX-License-Identifier: MIT
import { t } from "../shell/texts";

export function HealthPage() {
  return <h1 class="page-title">{t("health")}</h1>;
}
