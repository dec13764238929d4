// SPDX-License-Identifier: MIT
// The sphere in words: a label and a table, renewed once a second.
import { useEffect, useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { angle } from "../../shell/units";
import { voicesOf, type Voice } from "../voices";
import { t } from "../texts";
import { useView } from "../view";

export function SphereSummary() {
  const view = useView();
  const [voices, setVoices] = useState<Voice[]>([]);
  useEffect(() => {
    const renew = () => setVoices(voicesOf(view).filter((voice) => view.shows(voice.id)));
    renew();
    const timer = setInterval(renew, 1000);
    return () => clearInterval(timer);
  }, []);
  const words = voices.map((voice) => t("sphereVoice", { id: voice.id, az: angle(voice.az), el: angle(voice.el) })).join("; ");
  return (
    <>
      <div class="layer label" role="img" aria-label={words ? t("sphereVoices", { voices: words }) : t("sphereEmpty")} />
      <table class="visually-hidden">
        <caption>{t("tableCaption")}</caption>
        <thead>
          <tr>
            <th scope="col">{t("columnVoice")}</th>
            <th scope="col">{t("azimuth")}</th>
            <th scope="col">{t("elevation")}</th>
            <th scope="col">{t("columnActivity")}</th>
            <th scope="col">{t("columnLevel")}</th>
          </tr>
        </thead>
        <tbody>
          {voices.map((voice) => (
            <tr key={voice.id}>
              <th scope="row">{voice.id}</th>
              <td>{angle(voice.az)}</td>
              <td>{angle(voice.el)}</td>
              <td>{number(voice.activity, 2)}</td>
              <td>{voice.level === null ? "–" : `${number(voice.level)} dB`}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}
