// SPDX-License-Identifier: MIT
// What can be done with a direction: pin a beam, mute it. By a click on the sphere, or typed.
import { useEffect, useRef } from "preact/hooks";

import { Icon } from "../../shell/icons";
import { sayError } from "../../shell/toast";
import { angle } from "../../shell/units";
import type { Target, Vec3 } from "../../socket/messages";
import { azimuth, direction, elevation } from "../../store/angles";
import { useStudio, type Studio } from "../../studio";
import { t } from "../texts";

function freeTag(targets: Target[], mute: boolean): string {
  const stem = mute ? "mute" : "pin";
  for (let n = 1; ; n++) if (!targets.some((target) => target.tag === `${stem}${n}`)) return `${stem}${n}`;
}

export function addTarget(studio: Studio, at: Vec3, mute: boolean, tag = ""): void {
  const target = { tag: tag || freeTag(studio.store.targets.value, mute), direction: at, mute };
  studio.call<{ targets?: Target[] }>("targets.set", { add: [target] }).then((result) => take(studio, result), sayError);
}

function take(studio: Studio, result: { targets?: Target[] } | undefined): void {
  if (result?.targets) studio.store.targets.value = result.targets;
}

export function PinPopover({ x, y, at, close }: { x: number; y: number; at: Vec3; close: () => void }) {
  const studio = useStudio();
  const first = useRef<HTMLButtonElement>(null);
  useEffect(() => first.current?.focus(), []);
  const add = (mute: boolean) => () => {
    addTarget(studio, at, mute);
    close();
  };
  return (
    <div
      class="popover"
      role="dialog"
      aria-label={t("targets")}
      style={{ left: `clamp(0.5rem, ${x}px, calc(100% - 13rem))`, top: `clamp(0.5rem, ${y}px, calc(100% - 8rem))` }}
      onKeyDown={(event) => { if (event.key === "Escape") close(); }}
    >
      <p class="figures">{`${angle(azimuth(at[0], at[1]))} / ${angle(elevation(...at))}`}</p>
      <button ref={first} class="menu-item with-icon" onClick={add(false)}><Icon name="pin" />{t("pinBeam")}</button>
      <button class="menu-item with-icon" onClick={add(true)}><Icon name="mute" />{t("muteDirection")}</button>
    </div>
  );
}

/** The list of targets, and a form for those who do not point. */
export function TargetsPanel() {
  const studio = useStudio();
  const { store, call } = studio;
  if (!store.can("targets")) return null;
  const targets = store.targets.value;
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    const data = new FormData(event.currentTarget as HTMLFormElement);
    const at = direction(Number(data.get("az")), Number(data.get("el")));
    addTarget(studio, at, (event.submitter as HTMLButtonElement | null)?.value === "mute", String(data.get("tag") ?? "").trim());
  };
  const remove = (tag: string) => () => void call<{ targets?: Target[] }>("targets.set", { remove: [tag] }).then((result) => take(studio, result), sayError);
  return (
    <details class="panel fold">
      <summary>{t("targets")}{targets.length > 0 && <span class="count">{targets.length}</span>}</summary>
      <div class="panel-body targets">
        {targets.length === 0 && <p class="soft">{t("noTargets")}</p>}
        <ul>
          {targets.map((target) => (
            <li key={target.tag}>
              <Icon name={target.mute ? "mute" : "pin"} />
              <span class="grow">{target.tag}{target.mute && <span class="soft">{` (${t("muted")})`}</span>}</span>
              <span class="figures soft">{`${angle(azimuth(target.direction[0], target.direction[1]))} / ${angle(elevation(...target.direction))}`}</span>
              {store.operator.value && <button class="button ghost small icon-only" aria-label={t("remove", { tag: target.tag })} onClick={remove(target.tag)}><Icon name="close" /></button>}
            </li>
          ))}
        </ul>
        {store.operator.value && (
          <form onSubmit={submit}>
            <label><span>{t("targetName")}</span><input name="tag" type="text" maxLength={40} /></label>
            <label><span>{t("targetAzimuth")}</span><input name="az" type="number" min={-180} max={180} step="any" defaultValue="0" required /></label>
            <label><span>{t("targetElevation")}</span><input name="el" type="number" min={-90} max={90} step="any" defaultValue="0" required /></label>
            <button class="button small" value="pin">{t("addPin")}</button>
            <button class="button small" value="mute">{t("addMute")}</button>
          </form>
        )}
      </div>
    </details>
  );
}
