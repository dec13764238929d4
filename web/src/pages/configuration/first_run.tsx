// SPDX-License-Identifier: MIT
// Nothing is configured yet: which sound, which array, go.
import { useRef, useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { linkTo } from "../../shell/router";
import { useStudio } from "../../studio";
import { useAsked, useAskedList } from "../shared/asked";
import { useMayChange } from "../shared/notes";
import { t } from "./texts";

const kExample = "/srv/room.wav";

interface Device {
  interface: string;
  name: string;
  title?: string;
  channels?: number[];
  rates?: number[];
  formats?: (string | number)[];
}

/** `onOpened`: the engine has taken it. */
export function FirstRun({ onOpened = () => { location.hash = linkTo("live"); } }: { onOpened?: () => void }) {
  const { store, call } = useStudio();
  const devices = useAskedList<Device>("devices.list", {});
  const arrays = useAsked<{ name: string; title?: string }[]>("arrays.list", {});
  const [device, setDevice] = useState(0);
  const [source, setSource] = useState<"device" | "file">("device");
  const [path, setPath] = useState("");
  const [array, setArray] = useState("");
  const [problem, setProblem] = useState<string | null>(null);
  const [busy, setBusy] = useState(false);
  const input = useRef<HTMLInputElement>(null);
  const may = useMayChange();
  const found = devices.value ?? [];
  const chosen = found[device];
  const fromDevice = source === "device" && chosen !== undefined;
  const ready = array !== "" && (fromDevice || (source === "file" && path.trim() !== ""));

  const open = async (params: object) => {
    setBusy(true);
    setProblem(null);
    try {
      await call("engine.open", params);
      onOpened();
    } catch (error) {
      setProblem((error as Error).message);
    } finally {
      setBusy(false);
    }
  };
  const start = (event: Event) => {
    event.preventDefault();
    void open({ array, source: fromDevice ? deviceSource(chosen) : { type: "file", path: path.trim(), paced: true } });
  };
  const importFile = async (file: File | undefined) => {
    if (file) await open({ config: await file.text(), name: file.name.replace(/\.cfg$/, "") });
  };

  if (!store.operator.value) {
    return <div class="empty"><h2>{t("firstTitle")}</h2><p>{t("firstViewer")}</p></div>;
  }
  return (
    <form class="panel first-run" onSubmit={start}>
      <header><h2>{t("firstTitle")}</h2></header>
      <div class="panel-body stack">
        <p class="soft">{t("firstNext")}</p>
        <fieldset class="choices">
          <legend>{t("source")}</legend>
          <label class="menu-check"><input type="radio" name="source" checked={source === "device"} onChange={() => setSource("device")} /><span>{t("devices")}</span></label>
          {source === "device" && (
            <div class="stack choice">
              {found.map((one, i) => (
                <label key={one.name} class="menu-check device">
                  <input type="radio" name="device" checked={device === i} onChange={() => setDevice(i)} />
                  <span>{one.title || one.name}<small class="soft">{[one.name, one.channels?.length && `${t("channels")}: ${one.channels.join(", ")}`, one.rates?.length && one.rates.map((rate) => t("hertz", { n: number(rate) })).join(", ")].filter(Boolean).join(" · ")}</small></span>
                </label>
              ))}
              {devices.value && found.length === 0 && <p class="note warn">{t("noDevice")}</p>}
              {devices.error && <p class="note warn">{devices.error.message}</p>}
              <button class="button small" type="button" onClick={devices.again}>{t("searchAgain")}</button>
            </div>
          )}
          <label class="menu-check"><input type="radio" name="source" checked={source === "file"} onChange={() => setSource("file")} /><span>{t("file")}</span></label>
          {source === "file" && <input class="choice" type="text" value={path} placeholder={kExample} aria-label={t("filePath")} spellcheck={false} onInput={(event) => setPath(event.currentTarget.value)} />}
        </fieldset>
        <label class="stack">
          <span>{t("array")}</span>
          <select value={array} onChange={(event) => setArray(event.currentTarget.value)}>
            <option value="">{t("choose")}</option>
            {(arrays.value ?? []).map((one) => <option key={one.name} value={one.name}>{one.title ? `${one.title} (${one.name})` : one.name}</option>)}
          </select>
        </label>
        {problem && <p class="note bad" role="alert">{problem}</p>}
        <div class="row-wrap">
          <button class="button primary" type="submit" disabled={!may || !ready || busy}>{t("start")}</button>
          <span class="soft small-text">{t("orImport")}</span>
          <button class="button small" type="button" disabled={!may || busy} onClick={() => input.current!.click()}>{t("import")}</button>
          <input ref={input} type="file" accept=".cfg,text/plain" hidden onChange={(event) => void importFile(event.currentTarget.files?.[0])} />
        </div>
      </div>
    </form>
  );
}

/** The keys of `raw.interface` that open a device; what the array's configuration says of rate and channels holds. */
function deviceSource(device: Device): object {
  const key = device.interface === "soundcard_name" || device.interface === "soundcard" ? "devicename" : "source";
  return { type: device.interface, [key]: device.name };
}
