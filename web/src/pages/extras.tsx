// SPDX-License-Identifier: MIT
// What can be opened below the charts of the Live page: the spectrogram of the chosen voice, and the camera.
import { useView } from "../live/view";
import { lazy } from "../shell/lazy";
import { stored } from "../shell/stored";
import { useStudio } from "../studio";
import { t as camera } from "./camera/texts";
import { t as spectrogram } from "./spectrogram/texts";

const kNames = ["spectrogram", "camera"] as const;
type Name = (typeof kNames)[number];

const open = stored<Name[]>("extras", [], (value) => (Array.isArray(value) ? kNames.filter((name) => value.includes(name)) : []));

const LazySpectrogram = lazy(async () => (await import("./spectrogram/spectrogram")).Spectrogram);
const LazyCamera = lazy(async () => (await import("./camera/camera")).CameraPanel);

/** Two buttons at the edge of the charts. */
export function ExtrasButtons() {
  const { store, desk } = useStudio();
  const titles: Record<Name, string> = { spectrogram: spectrogram("title"), camera: camera("title") };
  const toggle = (name: Name) => {
    open.value = open.value.includes(name) ? open.value.filter((one) => one !== name) : [...open.value, name];
  };
  const offered = kNames.filter((name) => (name === "camera" ? Boolean(store.hello.value?.camera) || open.value.includes(name) : desk !== undefined));
  return (
    <div class="row-wrap extras-buttons">
      {offered.map((name) => <button key={name} class="button small" aria-pressed={open.value.includes(name)} onClick={() => toggle(name)}>{titles[name]}</button>)}
    </div>
  );
}

export function Extras() {
  const { store, desk } = useStudio();
  const view = useView();
  if (open.value.length === 0) return null;
  return (
    <div class="extras">
      {desk && open.value.includes("spectrogram") && (
        <LazySpectrogram
          track={view.selected.value} mics={store.run.value?.mics?.length ?? 1}
          onWish={(wishes) => desk.want("spectrogram", wishes)} listen={(take) => desk.listen(take)}
        />
      )}
      {open.value.includes("camera") && <LazyCamera shows={(track) => view.showsVoice(track.id, track.az, track.activity)} />}
    </div>
  );
}
