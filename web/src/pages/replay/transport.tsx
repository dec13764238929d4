// SPDX-License-Identifier: MIT
// The bar below a replay: play, go anywhere, faster, slower, again.
import { number } from "../../i18n/i18n";
import { clock } from "../../lib/bytes";
import { kSpeeds } from "../../lib/replayer";
import type { Session } from "../../lib/session";
import { Icon } from "../../shell/icons";
import { useKeys } from "../../shell/keys";
import type { Playback } from "./playback";
import { t } from "./texts";
import { Timeline } from "./timeline";

export function Transport({ playback, session }: { playback: Playback; session: Session }) {
  useTransportKeys(playback);
  const at = playback.position.value;
  const loop = playback.loop.value;
  const voices = session.sound.list();
  return (
    <section class="panel transport" aria-label={t("keys")}>
      <Timeline playback={playback} session={session} />
      <div class="transport-row">
        <button class="button icon-only primary" aria-label={t(playback.playing.value ? "pause" : "play")} title={t(playback.playing.value ? "pause" : "play")} onClick={() => playback.toggle()}>
          <Icon name={playback.playing.value ? "pause" : "play"} filled={!playback.playing.value} />
        </button>
        <button class="button small" aria-label={t("back")} title={t("back")} onClick={() => playback.seek(at - 5)}>−5</button>
        <button class="button small" aria-label={t("forward")} title={t("forward")} onClick={() => playback.seek(at + 5)}>+5</button>
        <output class="figures transport-time" aria-live="off">{t("positionOf", { at: clock(at, true), all: clock(session.seconds, true) })}</output>
        <label class="inline-field">
          <span>{t("speed")}</span>
          <select value={String(playback.speed.value)} onChange={(event) => playback.setSpeed(Number(event.currentTarget.value))}>
            {kSpeeds.map((speed) => <option key={speed} value={String(speed)}>{`${number(speed, speed < 1 ? 2 : 0)}×`}</option>)}
          </select>
        </label>
        <span class="row-wrap loop" role="group" aria-label={t("loop")}>
          <button class="button small" title={t("markA")} aria-label={t("markA")} onClick={() => playback.mark("a")}>A</button>
          <button class="button small" title={t("markB")} aria-label={t("markB")} onClick={() => playback.mark("b")}>B</button>
          <button class="button small" aria-pressed={playback.looping.value} onClick={() => playback.toggleLoop()}>{t("loop")}</button>
          {loop && <span class="figures small-text soft">{t("loopFrom", { a: clock(loop.a, true), b: clock(loop.b, true) })}</span>}
          {loop && <button class="button small ghost" onClick={() => playback.clearLoop()}>{t("clearLoop")}</button>}
        </span>
        {voices.length > 0 ? (
          <label class="inline-field">
            <span>{t("sound")}</span>
            <select value={playback.voiceKey.value} onChange={(event) => playback.choose(event.currentTarget.value)}>
              <option value="">{t("silent")}</option>
              {playback.voices.map(({ key, stream, source }) => (
                <option key={key} value={key}>{stream === "raw" ? t("mic", { n: source }) : t("voice", { n: source, stream: t(stream) })}</option>
              ))}
            </select>
          </label>
        ) : (
          <span class="soft small-text">{t("noSound")}</span>
        )}
      </div>
    </section>
  );
}

function useTransportKeys(playback: Playback): void {
  const group = () => t("keys");
  useKeys(() => [
    { keys: [" "], label: "␣", meaning: () => t("keyPlay"), group, run: () => playback.toggle() },
    {
      keys: ["ArrowLeft", "ArrowRight"], label: "← →", meaning: () => t("keySteps"), group,
      run: (event) => playback.seek(playback.position.value + (event.key === "ArrowLeft" ? -5 : 5)),
    },
    { keys: [",", "."], label: ", .", meaning: () => t("keyHops"), group, run: (event) => playback.step(event.key === "," ? -1 : 1) },
    { keys: ["a", "b"], label: "A B", meaning: () => t("keyMarks"), group, run: (event) => playback.mark(event.key.toLowerCase() as "a" | "b") },
    { keys: ["-", "+"], label: "− +", meaning: () => t("keySpeed"), group, run: (event) => playback.faster(event.key === "+" ? 1 : -1) },
  ]);
}
