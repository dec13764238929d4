// SPDX-License-Identifier: MIT
// What the draft is, what would come of it, and the buttons that make it so.
import { useRef, useState } from "preact/hooks";

import { say, sayError } from "../../shell/toast";
import { Confirm } from "../shared/confirm";
import { saveFile } from "../shared/save_file";
import type { Draft } from "./draft";
import { t } from "./texts";

export function Bar({ draft, may }: { draft: Draft; may: boolean }) {
  const input = useRef<HTMLInputElement>(null);
  const [naming, setNaming] = useState(false);
  const [name, setName] = useState("");
  const [busy, setBusy] = useState(false);
  const running = draft.running.value;
  const errors = draft.errors.value.length;
  const warnings = draft.warnings.value.length;
  const effect = draft.effect.value;
  const act = async (what: () => Promise<void>) => {
    setBusy(true);
    await what().catch(sayError);
    setBusy(false);
  };
  const apply = () => act(async () => say(t("applied", { what: t(`effect_${await draft.apply()}`) })));
  const revert = () => act(async () => say(t("reverted", { what: t(`effect_${await draft.revert()}`) })));
  const save = (as?: string) => act(async () => say(t("savedTo", { file: await draft.save(as) })));
  const importFile = async (file: File | undefined) => {
    if (file) await draft.replace(await file.text());
  };
  return (
    <section class="panel config-bar" aria-label={t("name")}>
      <div class="config-state">
        <strong class="recording-title">{running?.name ?? ""}</strong>
        <span class="small-text soft">{t(running?.dirty ? "dirty" : "saved")}</span>
        <span class={`badge ${draft.changed.value ? "warn" : ""}`}>{t(draft.changed.value ? "unapplied" : "runsThis")}</span>
        <span role="status" class="row-wrap">
          {draft.checking.value && <span class="small-text soft">{t("checking")}</span>}
          {!draft.checking.value && errors + warnings === 0 && <span class="small-text good-text">{t("noFaults")}</span>}
          {errors > 0 && <span class="badge bad">{t("errors", { n: errors })}</span>}
          {warnings > 0 && <span class="badge warn">{t("warnings", { n: warnings })}</span>}
          {draft.changed.value && errors === 0 && effect && <span class="small-text">{`${t("effect")}: ${t(`effect_${effect}`)}`}</span>}
        </span>
      </div>
      <div class="row-wrap">
        {may && <button class="button primary" disabled={busy || draft.checking.value || !draft.changed.value || errors > 0} onClick={apply}>{t("apply")}</button>}
        {may && draft.changed.value && <button class="button" onClick={() => void draft.replace(running?.text ?? "")}>{t("discard")}</button>}
        {may && <button class="button" disabled={busy || !running?.previous} title={t("revertTip")} onClick={revert}>{t("revert")}</button>}
        {may && <button class="button" disabled={busy || draft.changed.value} onClick={() => save()}>{t("save")}</button>}
        {may && <button class="button" disabled={busy || draft.changed.value} onClick={() => setNaming(true)}>{t("saveAs")}</button>}
        {may && <button class="button" onClick={() => input.current!.click()}>{t("import")}</button>}
        <button class="button" onClick={() => saveFile(new Blob([draft.text.value ?? ""], { type: "text/plain" }), `${running?.name || "odas"}.cfg`)}>{t("export")}</button>
        <input ref={input} type="file" accept=".cfg,text/plain" hidden onChange={(event) => { void importFile(event.currentTarget.files?.[0]); event.currentTarget.value = ""; }} />
      </div>
      {naming && (
        <Confirm title={t("saveAs")} action={t("save")} onAnswer={(yes) => { setNaming(false); if (yes && /^[\w-]+$/.test(name)) void save(name); }}>
          <label class="stack">
            <span>{t("saveName")}</span>
            <input type="text" value={name} spellcheck={false} aria-describedby="save-hint" onInput={(event) => setName(event.currentTarget.value)} />
          </label>
          <p id="save-hint" class="soft">{t("saveNameHint")}</p>
        </Confirm>
      )}
    </section>
  );
}
