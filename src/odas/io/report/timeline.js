// SPDX-License-Identifier: MIT
// Angles and waveforms over one common axis of time.
const kGutter = 52, kRight = 14;  // --gutter in report.css
const kBottom = 22;
const shown = { from: 0, to: data.seconds };  // the stretch of time in sight
const perSecond = (width) => (width - kGutter - kRight) / (shown.to - shown.from);
const timeToX = (time, width) => kGutter + (time - shown.from) * perSecond(width);
const xToTime = (x, width) => Math.min(shown.to, Math.max(shown.from, shown.from + (x - kGutter) / perSecond(width)));

function show(from, length) {
  shown.from = Math.max(0, Math.min(data.seconds - length, from));
  shown.to = shown.from + length;
}

/** Shows `factor` times as much time as now; `time` keeps its place. */
function zoom(factor, time) {
  const length = shown.to - shown.from;
  const next = Math.min(data.seconds, Math.max(Math.min(1, data.seconds), length * factor));
  show(time - ((time - shown.from) * next) / length, next);
}

/** Turns the page where `time` has left it; true if so. */
function bringIntoSight(time) {
  if (time >= shown.from && time <= shown.to) return false;
  const length = shown.to - shown.from;
  show(time < shown.from ? time - 0.9 * length : time - 0.1 * length, length);
  return true;
}

function timeStep(width) {
  const steps = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];
  return steps.find((s) => s * perSecond(width) >= 64) || 7200;
}

/** Draws an angle of all sources and potentials. `wraps`: -180 and 180 are one place. */
function drawAngles(canvas, key, low, high, step, wraps) {
  const [c, width, height] = fit(canvas);
  const y = (angle) => 6 + ((high - angle) / (high - low)) * (height - kBottom - 6);
  c.font = "12px system-ui, sans-serif";
  c.textBaseline = "middle";
  c.textAlign = "right";
  for (let angle = low; angle <= high; angle += step) {
    c.fillStyle = theme("--grid");
    c.fillRect(kGutter, Math.round(y(angle)), width - kGutter - kRight, 1);
    c.fillStyle = theme("--quiet");
    c.fillText(signed(angle), kGutter - 8, y(angle));
  }
  const tick = timeStep(width);
  c.textAlign = "center";
  for (let time = Math.ceil(shown.from / tick) * tick; time <= shown.to; time += tick) {
    c.fillStyle = theme("--grid");
    c.fillRect(Math.round(timeToX(time, width)), 6, 1, height - kBottom - 6);
    c.fillStyle = theme("--quiet");
    c.fillText(clock(time, tick < 1 ? 1 : 0), Math.min(timeToX(time, width), width - 18), height - 8);
  }

  c.save();
  c.beginPath();
  c.rect(kGutter, 0, width - kGutter - kRight, height - kBottom + 4);
  c.clip();
  drawPotentials(c, key, (time) => timeToX(time, width), y);
  for (const source of data.sources) drawTrack(c, source, key, (time) => timeToX(time, width), y, wraps);
  const labels = [];
  for (const source of data.sources) drawLabel(c, source, key, [width, height], y, labels);
  c.restore();
}

function drawPotentials(c, key, x, y) {
  const { t, energy } = data.potentials, angles = data.potentials[key];
  c.fillStyle = theme("--dot");
  for (let k = 0; k < t.length; ++k) {
    c.globalAlpha = Math.min(0.6, 0.12 + 0.8 * energy[k]);
    c.fillRect(x(t[k]) - 1, y(angles[k]) - 1, 2, 2);
  }
  c.globalAlpha = 1;
}

function drawTrack(c, source, key, x, y, wraps) {
  const angles = source[key];
  c.strokeStyle = theme(source.colour);
  c.setLineDash(source.dash);
  c.lineJoin = c.lineCap = "round";
  for (const active of [false, true]) {
    c.lineWidth = active ? 3 : 1.25;
    c.globalAlpha = active ? 1 : 0.65;
    c.beginPath();
    for (let k = 1; k < source.t.length; ++k) {
      if (source.activity[k] >= 0.5 !== active) continue;
      const x0 = x(source.t[k - 1]), x1 = x(source.t[k]), a0 = angles[k - 1], a1 = angles[k];
      // The short way round: through the edge of the plot, not across it.
      const turn = wraps && Math.abs(a1 - a0) > 180 ? (a1 > a0 ? 360 : -360) : 0;
      c.moveTo(x0, y(a0));
      c.lineTo(x1, y(a1 - turn));
      if (turn) {
        c.moveTo(x0, y(a0 + turn));
        c.lineTo(x1, y(a1));
      }
    }
    c.stroke();
  }
  c.globalAlpha = 1;
  c.setLineDash([]);
}

/** The number of a source where it is first in sight, unless another number is there. */
function drawLabel(c, source, key, [width, height], y, labels) {
  if (source.to < shown.from || source.from > shown.to) return;
  const text = String(source.id), half = 7 + 3.2 * text.length;
  const first = Math.max(source.from, shown.from);
  const x = Math.max(kGutter + half, Math.min(timeToX(first, width), width - kRight - half));
  const top = Math.max(9, Math.min(height - kBottom - 6, y(placeAt(source, first)[key])));
  if (labels.some((l) => Math.abs(l.x - x) < l.half + half && Math.abs(l.top - top) < 18)) return;
  labels.push({ x, top, half });
  c.fillStyle = theme(source.colour);
  c.beginPath();
  c.roundRect(x - half, top - 9, 2 * half, 18, 9);
  c.fill();
  c.fillStyle = theme("--card");
  c.font = "600 12px system-ui, sans-serif";
  c.textAlign = "center";
  c.fillText(text, x, top + 0.5);
}

/** `clip.peaks`: the loudest sample of each equal stretch, 0..100 of the clip's own peak. */
function drawWaveform(canvas, clip) {
  const [c, fullWidth, height] = fit(canvas);
  const width = fullWidth + kGutter;  // this canvas begins right of the gutter
  c.beginPath();
  c.rect(0, 0, fullWidth - kRight, height);
  c.clip();
  const left = timeToX(clip.start, width) - kGutter, right = timeToX(clip.start + clip.length, width) - kGutter;
  c.fillStyle = theme("--grid");
  c.fillRect(0, height / 2, fullWidth - kRight, 1);
  c.fillStyle = theme(clip.colour || "--quiet");
  const per = (right - left) / clip.peaks.length;
  clip.peaks.forEach((peak, k) => {
    const h = Math.max(1, (peak / 100) * (height - 4));
    c.fillRect(left + k * per, (height - h) / 2, Math.max(per, 0.6), h);
  });
}
