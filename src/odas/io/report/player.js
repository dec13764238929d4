// SPDX-License-Identifier: MIT
// One clip sounds at a time, all share one position in the recording.
const player = { time: 0, playing: false, clip: data.clips.at(-1), onmove: () => {}, onstate: () => {} };

/** The clip's sound: from this page where it was small enough to be carried along, else from its file. */
function audioOf(clip) {
  if (!clip.audio) {
    const carried = byId(`audio-${data.clips.indexOf(clip)}`);
    if (carried) {
      const bytes = Uint8Array.from(atob(carried.textContent.trim()), (ch) => ch.charCodeAt(0));
      clip.audio = new Audio(URL.createObjectURL(new Blob([bytes], { type: "audio/wav" })));
    } else {
      clip.audio = new Audio(clip.file.split("/").map(encodeURIComponent).join("/"));
    }
    clip.audio.addEventListener("ended", pause);
    clip.audio.addEventListener("error", () => { pause(); clip.failed = true; player.onstate(); });
  }
  return clip.audio;
}

function seek(time) {
  player.time = Math.max(0, Math.min(data.seconds, time));
  if (player.playing) {
    if (within(player.clip)) audioOf(player.clip).currentTime = player.time - player.clip.start;
    else pause();
  }
  player.onmove();
}

const within = (clip) => player.time >= clip.start && player.time < clip.start + clip.length - 0.05;

/** Plays from the common position; from the clip's own start where the position lies outside of it. */
function play(clip = player.clip) {
  if (!clip) return;
  pause();
  player.clip = clip;
  if (!within(clip)) player.time = clip.start;
  const audio = audioOf(clip);
  const begin = () => { audio.currentTime = Math.max(0, player.time - clip.start); };
  if (audio.readyState > 0) begin(); else audio.addEventListener("loadedmetadata", begin, { once: true });
  player.playing = true;
  player.onstate();
  audio.play().then(follow, () => { if (player.clip === clip) pause(); });
}

function pause() {
  player.playing = false;
  player.clip?.audio?.pause();
  player.onstate();
}

function follow() {
  if (!player.playing) return;
  player.time = Math.min(data.seconds, player.clip.start + player.clip.audio.currentTime);
  player.onmove();
  requestAnimationFrame(follow);
}
