// SPDX-License-Identifier: MIT
// Puts the parts of the page together.
function fillHeader() {
  byId("title").textContent = `What was heard in ${data.title}`;
  const count = data.sources.length;
  const voices = count === 0 ? "No source was followed" : count === 1 ? "One source" : `${count} sources`;
  byId("summary").textContent = `${voices} in ${clock(data.seconds)}, ${data.mics.length} microphones.`;
  byId("warnings").hidden = data.warnings.length === 0;
  byId("warnings").append(...data.warnings.map((w) => element("li", {}, w)));
  for (const [name, value] of data.facts) byId("facts").append(element("dt", {}, name), element("dd", {}, value));
}

function fillTable() {
  const head = ["Source", "From", "To", "Azimuth", "Elevation", "Active", "Voice"];
  const rows = data.sources.map((s) => element("tr", {},
    element("td", {}, chip(s), s.tag && s.tag !== "dynamic" ? ` ${s.tag}` : ""),
    element("td", {}, clock(s.from)), element("td", {}, clock(s.to)),
    element("td", {}, span(s.places.azimuth)), element("td", {}, span(s.places.elevation)),
    element("td", {}, `${Math.round(100 * s.share)} %`),
    element("td", {}, s.file ? element("a", { href: link(s.file) }, s.file) : "–")));
  byId("sources").append(
    element("thead", {}, element("tr", {}, ...head.map((h) => element("th", { scope: "col" }, h)))),
    element("tbody", {}, ...rows));
  if (rows.length === 0) byId("who").hidden = true;
}

const link = (file) => file.split("/").map(encodeURIComponent).join("/");
const chip = (s) => element("span", { class: "chip", style: `--colour: var(${s.colour})` }, String(s.id));
/** "45°", or "45° → 60°" where it changed. */
function span({ mean, from, to }) {
  const change = Math.abs(from - to);
  return Math.min(change, 360 - change) >= kMoved ? `${signed(from)} → ${signed(to)}` : signed(mean);
}
const kMoved = 10;

function addClips() {
  for (const clip of data.clips) {
    clip.button = element("button", { type: "button", "aria-label": `Play ${clip.name}`, "aria-pressed": "false" }, "▶");
    clip.button.addEventListener("click", () => (player.playing && player.clip === clip ? pause() : play(clip)));
    clip.canvas = element("canvas", { role: "img", "aria-label":
      `Waveform of ${clip.name}, from ${clock(clip.start)} to ${clock(clip.start + clip.length)}` });
    const name = element("div", { class: "name" }, element("b", {}, clip.name));
    if (clip.places) name.append(element("span", {},
      `${clock(clip.from)} to ${clock(clip.to)}, azimuth ${span(clip.places.azimuth)}, elevation ${span(clip.places.elevation)}`));
    name.append(element("span", {}, `peak ${clip.peak_db} dB`.replace("-", "−")));
    if (clip.file) name.append(element("a", { href: link(clip.file) }, clip.file.split("/").at(-1)));
    clip.row = element("div", { class: "clip", style: `--colour: var(${clip.colour || "--quiet"})` },
      name, clip.button, clip.canvas);
    byId("clips").append(clip.row);
    byId("listen").append(element("option", {}, clip.name));
    scrubbed(clip.canvas, kGutter);
  }
  if (data.clips.length > 0) return;
  byId("clips").append(element("p", { class: "hint" }, "No sound was written."));
  byId("play").hidden = byId("listen").hidden = true;
}

/** A press or a drag on the canvas moves the common position. */
function scrubbed(canvas, gutter = 0) {
  const move = (e) => seek(xToTime(e.offsetX + gutter, canvas.clientWidth + gutter));
  canvas.addEventListener("pointerdown", (e) => { canvas.setPointerCapture(e.pointerId); move(e); });
  canvas.addEventListener("pointermove", (e) => { if (canvas.hasPointerCapture(e.pointerId)) move(e); });
}

function showPosition() {
  if (bringIntoSight(player.time)) drawTimeline();
  const now = clock(player.time);
  byId("cursor").style.left = `${timeToX(player.time, byId("timeline").clientWidth)}px`;
  byId("clock").textContent = byId("now-time").textContent = now;
  byId("seek").value = player.time;
  byId("seek").setAttribute("aria-valuetext", now);
  const lines = followedAt(player.time).map((s) => {
    const at = placeAt(s, player.time);
    return element("li", {}, chip(s), ` azimuth ${signed(at.azimuth)}, elevation ${signed(at.elevation)}`,
      at.activity >= 0.5 ? "" : ", quiet");
  });
  byId("now").replaceChildren(...(lines.length ? lines : [element("li", {}, "nobody is followed")]));
  drawSphere(byId("sphere"), player.time);
}

function showState() {
  const { playing, clip } = player;
  for (const c of data.clips) {
    const on = playing && c === clip;
    c.button.textContent = on ? "❚❚" : "▶";
    c.button.setAttribute("aria-pressed", String(on));
    c.button.setAttribute("aria-label", `${on ? "Pause" : "Play"} ${c.name}`);
    if (c.failed) c.button.title = "This sound cannot be opened: is the file still beside the report?";
  }
  byId("play").textContent = playing ? "❚❚" : "▶";
  byId("play").setAttribute("aria-label", playing ? "Pause" : "Play");
  byId("listen").selectedIndex = data.clips.indexOf(clip);
}

const lowest = [data.potentials, ...data.sources].flatMap((s) => s.elevation).reduce((a, b) => Math.min(a, b), 0);
function drawTimeline() {
  drawAngles(byId("azimuth"), "azimuth", -180, 180, 90, true);
  drawAngles(byId("elevation"), "elevation", lowest < -5 ? -90 : 0, 90, lowest < -5 ? 45 : 30, false);
  for (const clip of data.clips) {
    clip.row.hidden = clip.start > shown.to || clip.start + clip.length < shown.from;
    if (!clip.row.hidden) drawWaveform(clip.canvas, clip);
  }
}

function drawAll() {
  drawTimeline();
  showPosition();
}

function describePlots() {
  const words = (key) => data.sources.map((s) => `${s.name} ${span(s.places[key])} from ${clock(s.from)} to ${clock(s.to)}`);
  for (const key of ["azimuth", "elevation"]) {
    byId(key).setAttribute("aria-label", `Plot of ${key} over time. ${words(key).join("; ") || "No source."}`);
  }
  byId("sphere").setAttribute("aria-label", `Unit sphere with ${data.mics.length} microphones and the sources at the current time`);
}

fillHeader();
fillTable();
addClips();
describePlots();
for (const key of ["azimuth", "elevation"]) scrubbed(byId(key));
makeTurnable(byId("sphere"), () => drawSphere(byId("sphere"), player.time));
for (const [id, factor] of [["zoom-in", 0.5], ["zoom-out", 2]]) {
  byId(id).addEventListener("click", () => { zoom(factor, player.time); drawAll(); });
}
player.onmove = showPosition;
player.onstate = showState;
byId("seek").max = data.seconds;
byId("seek").addEventListener("input", (e) => seek(Number(e.target.value)));
byId("play").addEventListener("click", () => (player.playing ? pause() : play()));
byId("listen").addEventListener("change", (e) => {
  const clip = data.clips[e.target.selectedIndex];
  if (player.playing) play(clip); else player.clip = clip;
});
document.addEventListener("keydown", (e) => {
  if (e.key !== " " || e.target.closest("button, select, input, a, [tabindex='0']")) return;
  e.preventDefault();
  if (player.playing) pause(); else play();
});
new ResizeObserver(drawAll).observe(byId("timeline"));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
// report.html#t=8.5 opens at 8.5 s; else where the first source appears.
player.time = Math.min(data.seconds, Number(location.hash.match(/^#t=([\d.]+)$/)?.[1] ?? data.sources[0]?.from ?? 0));
showState();
drawAll();
