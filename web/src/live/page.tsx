// SPDX-License-Identifier: MIT
import { useViewLink } from "./link";
import { LiveView } from "./liveview";
import { t } from "./texts";

export function LivePage() {
  return (
    <>
      <h1 class="visually-hidden">{t("title")}</h1>
      <LiveView use={useViewLink} />
    </>
  );
}
