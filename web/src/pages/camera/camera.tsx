// SPDX-License-Identifier: MIT
// The picture of a camera with a mark where each voice is.
import { useState } from "preact/hooks";

import { number } from "../../i18n/i18n";
import { project, readPinhole, type Pinhole } from "../../lib/pinhole";
import { linkTo } from "../../shell/router";
import { shownTheme } from "../../shell/theme";
import { angle } from "../../shell/units";
import { kPalettes } from "../../store/colors";
import type { Track } from "../../store/tracks";
import { useStore } from "../../studio";
import { t } from "./texts";

const kDistances = [0.5, 1, 2, 3, 5, 10];

export function CameraPanel({ shows = () => true }: { shows?: (track: Track) => boolean }) {
  const store = useStore();
  const [distance, setDistance] = useState(Infinity);
  const camera = readPinhole(store.hello.value?.camera);
  store.beat.value;
  return (
    <section class="panel camera" aria-labelledby="camera-title">
      <header>
        <h2 id="camera-title">{t("title")}</h2>
        {camera?.position.some((c) => c !== 0) && (
          <label class="inline-field">
            <span>{t("distance")}</span>
            <select value={String(distance)} onChange={(event) => setDistance(Number(event.currentTarget.value))}>
              <option value="Infinity">{t("far")}</option>
              {kDistances.map((metres) => <option key={metres} value={String(metres)}>{t("metres", { n: number(metres, metres < 1 ? 1 : 0) })}</option>)}
            </select>
          </label>
        )}
      </header>
      {camera ? <Picture camera={camera} distance={distance} tracks={store.liveTracks().filter(shows)} /> : (
        <div class="empty">
          <h3>{t("none")}</h3>
          <p>{t("noneNext")}</p>
          <a class="button small" href={linkTo("configuration", new URLSearchParams({ tab: "form" }))}>{t("toConfig")}</a>
        </div>
      )}
    </section>
  );
}

function Picture({ camera, distance, tracks }: { camera: Pinhole; distance: number; tracks: Track[] }) {
  const [failed, setFailed] = useState(false);
  const [attempt, setAttempt] = useState(0);
  if (failed) {
    return (
      <div class="empty" role="alert">
        <h3>{t("failed")}</h3>
        <p>{t("failedNext", { url: camera.url })}</p>
        <button class="button small" onClick={() => { setAttempt(attempt + 1); setFailed(false); }}>{t("tryAgain")}</button>
      </div>
    );
  }
  const palette = kPalettes[shownTheme.value === "light" ? "light" : "dark"];
  const placed = tracks.map((track) => ({ track, at: project(camera, [track.x, track.y, track.z], distance) }));
  const inside = placed.filter(({ at }) => at !== null);
  const name = (list: typeof placed) => list.map(({ track }) => t("source", { id: track.tag === "dynamic" ? track.id : track.tag, az: angle(track.az), el: angle(track.el) })).join(", ");
  const outside = name(placed.filter(({ at }) => at === null));
  return (
    <>
      <div class="camera-picture" style={{ aspectRatio: `${camera.width} / ${camera.height}` }}>
        <img key={attempt} src={camera.url} alt="" onError={() => setFailed(true)} />
        <svg viewBox={`0 0 ${camera.width} ${camera.height}`} role="img" aria-label={inside.length > 0 ? t("label", { n: inside.length, list: name(inside) }) : t("labelNone")}>
          {inside.map(({ track, at }) => <Mark key={track.id} track={track} x={at!.x} y={at!.y} size={camera.width / 640} color={palette[track.look.color]!} />)}
        </svg>
      </div>
      {outside && <p class="camera-outside small-text soft">{t("outside", { list: outside })}</p>}
    </>
  );
}

/** A ring with a dark and a light edge: it can be seen on any picture. */
function Mark({ track, x, y, size, color }: { track: Track; x: number; y: number; size: number; color: string }) {
  const r = 18 * size;
  return (
    <g transform={`translate(${x} ${y})`} data-track={track.id} opacity={0.45 + 0.55 * Math.min(1, track.activity)}>
      <circle r={r} fill="none" stroke="#000" stroke-width={7 * size} />
      <circle r={r} fill="none" stroke="#fff" stroke-width={5 * size} />
      <circle r={r} fill="none" stroke={color} stroke-width={3.5 * size} />
      <text y={-r - 6 * size} text-anchor="middle" font-size={15 * size} font-weight="700" fill="#fff" stroke="#000" stroke-width={3 * size} paint-order="stroke">
        {track.tag === "dynamic" ? track.id : track.tag}
      </text>
    </g>
  );
}
