// SPDX-License-Identifier: MIT
// What the run found, and the small helpers that every part of the page uses.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
const degrees = (radians) => (radians * 180) / Math.PI;

const kColours = 6;
for (const [i, source] of data.sources.entries()) {
  // A colour belongs to its source everywhere on the page. Beyond six sources the dash tells them apart too.
  source.colour = `--s${i % kColours}`;
  source.dash = [[], [7, 4], [2, 3]][Math.floor(i / kColours) % 3];
  source.name = `Source ${source.id}`;
  source.azimuth = source.t.map((_, k) => degrees(Math.atan2(source.y[k], source.x[k])));
  source.elevation = source.t.map((_, k) => degrees(Math.atan2(source.z[k], Math.hypot(source.x[k], source.y[k]))));
}
data.clips = [...data.sources.filter((s) => s.file), ...(data.reference ? [data.reference] : [])];

/** A colour of the theme that is in force now. */
const theme = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Makes an element: text is set as text, never read as HTML. */
function element(tag, attributes = {}, ...children) {
  const e = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  e.append(...children);
  return e;
}

/** 7.2 s, or 1:07.2 in long recordings. */
function clock(seconds, digits = 1) {
  if (data.seconds < 120) return `${seconds.toFixed(digits)} s`;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - 60 * minutes).toFixed(digits).padStart(digits ? 3 + digits : 2, "0")}`;
}

const signed = (angle) => `${Math.round(angle)}°`.replace("-", "−");

/** Sizes the canvas to its box in device pixels; gives a context that draws in CSS pixels. */
function fit(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const c = canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.clearRect(0, 0, width, height);
  return [c, width, height];
}

/** Index of the last point at or before `time` (points are in order of time); -1: none. */
function indexAt(times, time) {
  let low = 0, high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1; else high = middle;
  }
  return low - 1;
}

/** Sources that were followed at `time`. */
const followedAt = (time) => data.sources.filter((s) => s.from <= time && time <= s.to);

/** Where a source was at `time`: {x, y, z, azimuth, elevation, activity}. */
function placeAt(source, time) {
  const k = Math.max(0, indexAt(source.t, time));
  return Object.fromEntries(["x", "y", "z", "azimuth", "elevation", "activity"].map((key) => [key, source[key][k]]));
}
