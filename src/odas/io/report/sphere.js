// SPDX-License-Identifier: MIT
// The unit sphere around the microphones, seen from outside in parallel projection.
const kHome = { turn: -0.6, tilt: 0.5 };
const kTrail = 3;  // seconds
const view = { ...kHome };

/** Right, up, and towards the eye, each -1..1. */
function project(x, y, z) {
  const ct = Math.cos(view.turn), st = Math.sin(view.turn), ci = Math.cos(view.tilt), si = Math.sin(view.tilt);
  const right = -x * st + y * ct, front = x * ct + y * st;
  return [right, z * ci - front * si, front * ci + z * si];
}

function strokePath(c, points, at) {
  // What lies behind the sphere is drawn fainter.
  for (const near of [false, true]) {
    c.globalAlpha = near ? 1 : 0.35;
    c.beginPath();
    for (let k = 1; k < points.length; ++k) {
      if (points[k][2] >= 0 !== near) continue;
      c.moveTo(...at(points[k - 1]));
      c.lineTo(...at(points[k]));
    }
    c.stroke();
  }
  c.globalAlpha = 1;
}

function circle(height, meridian) {
  const points = [];
  for (let k = 0; k <= 72; ++k) {
    const a = (k / 72) * 2 * Math.PI, r = Math.sqrt(1 - height * height);
    points.push(meridian === undefined ? project(r * Math.cos(a), r * Math.sin(a), height)
      : project(Math.cos(a) * Math.cos(meridian), Math.cos(a) * Math.sin(meridian), Math.sin(a)));
  }
  return points;
}

function drawSphere(canvas, time) {
  const [c, width, height] = fit(canvas);
  const radius = Math.min(width - 40, height) / 2 - 20;
  const at = ([right, up]) => [width / 2 + radius * right, height / 2 - radius * up];

  c.fillStyle = theme("--page");
  c.beginPath();
  c.arc(width / 2, height / 2, radius, 0, 2 * Math.PI);
  c.fill();
  c.strokeStyle = theme("--line");
  for (const elevation of [-60, -30, 30, 60]) strokePath(c, circle(Math.sin((elevation * Math.PI) / 180)), at);
  for (let k = 0; k < 6; ++k) strokePath(c, circle(0, (k * Math.PI) / 6), at);
  c.strokeStyle = theme("--quiet");
  strokePath(c, circle(0), at);

  drawAxes(c, at);
  drawMics(c, at);
  drawNear(c, at, time);
  for (const source of data.sources) drawTrail(c, source, at, time);
}

function drawAxes(c, at) {
  c.font = "12px system-ui, sans-serif";
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.fillStyle = c.strokeStyle = theme("--quiet");
  for (const [name, ...p] of [["x 0°", 1, 0, 0], ["y 90°", 0, 1, 0], ["z", 0, 0, 1]]) {
    const tip = project(...p);
    c.globalAlpha = tip[2] >= 0 ? 1 : 0.5;
    c.beginPath();
    c.moveTo(...at([0, 0]));
    c.lineTo(...at(tip));
    c.stroke();
    c.fillText(name, ...at(tip.map((v) => 1.13 * v)));
  }
  c.globalAlpha = 1;
}

/** The array is drawn larger than it is: its farthest microphone at a third of the sphere. */
function drawMics(c, at) {
  const size = Math.max(1e-6, ...data.mics.map((m) => Math.hypot(...m)));
  c.fillStyle = theme("--ink");
  for (const mic of data.mics) {
    c.beginPath();
    c.arc(...at(project(...mic.map((v) => v / size / 3))), 3, 0, 2 * Math.PI);
    c.fill();
  }
}

function drawNear(c, at, time) {
  const { t, azimuth, elevation, energy } = data.potentials;
  c.fillStyle = theme("--dot");
  for (let k = indexAt(t, time); k >= 0 && t[k] > time - 0.3; --k) {
    const a = (azimuth[k] * Math.PI) / 180, e = (elevation[k] * Math.PI) / 180;
    const p = project(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    c.globalAlpha = Math.min(0.8, 0.15 + energy[k]) * (p[2] >= 0 ? 1 : 0.4);
    c.beginPath();
    c.arc(...at(p), 2, 0, 2 * Math.PI);
    c.fill();
  }
  c.globalAlpha = 1;
}

function drawTrail(c, source, at, time) {
  const last = indexAt(source.t, time);
  if (last < 0 || time > source.to + kTrail) return;
  const points = [];
  for (let k = last; k >= 0 && source.t[k] > time - kTrail; --k) points.push(project(source.x[k], source.y[k], source.z[k]));
  if (points.length === 0) return;
  c.strokeStyle = c.fillStyle = theme(source.colour);
  c.lineWidth = 3;
  strokePath(c, points, at);
  c.lineWidth = 1;
  if (time > source.to) return;
  const [x, y] = at(points[0]);
  c.globalAlpha = points[0][2] >= 0 ? 1 : 0.55;
  c.beginPath();
  c.arc(x, y, 10, 0, 2 * Math.PI);
  c.fill();
  c.fillStyle = theme("--card");
  c.font = "600 12px system-ui, sans-serif";
  c.fillText(String(source.id), x, y + 0.5);
  c.globalAlpha = 1;
}

/** Turning by pointer and by keys; `redraw` is called after each turn. */
function makeTurnable(canvas, redraw) {
  const turn = (by, up) => {
    view.turn += by;
    view.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, view.tilt + up));
    redraw();
  };
  let last = null;
  canvas.addEventListener("pointerdown", (e) => {
    canvas.setPointerCapture(e.pointerId);
    last = e;
  });
  canvas.addEventListener("pointermove", (e) => {
    if (!canvas.hasPointerCapture(e.pointerId)) return;
    turn((last.clientX - e.clientX) * 0.01, (e.clientY - last.clientY) * 0.01);
    last = e;
  });
  canvas.addEventListener("keydown", (e) => {
    const step = { ArrowLeft: [0.15, 0], ArrowRight: [-0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15] }[e.key];
    if (step) turn(...step);
    else if (e.key === "Home") { Object.assign(view, kHome); redraw(); }
    else return;
    e.preventDefault();
  });
}
