// SPDX-License-Identifier: MIT
// A daemon's configuration in small: a few keys, their form, edits, faults; for tests of the page.

const kFields = {
  raw: [
    ["fS", "int", { unit: "Hz", min: 1000, max: 384000, required: true, meaning: "sample rate of the input" }],
    ["nChannels", "int", { min: 1, max: 1024, required: true, meaning: "channels of the input" }],
    ["interface", "group", { meaning: "where the sound comes from", fields: [["type", "string", { choices: ["file", "soundcard_name", "stdin"], default: "file", meaning: "kind of source" }], ["path", "string", { default: "", meaning: "file: its path" }]] }],
  ],
  mapping: [["map", "ints", { min: 0, max: 1024, default: [], meaning: "input channel of each microphone, from 1; 0 is silence" }]],
  general: [
    ["speedofsound", "group", { fields: [["mu", "float", { unit: "m/s", min: 0, min_excluded: true, default: 343, meaning: "speed of sound" }]] }],
    ["mics", "list", { required: true, meaning: "the microphones, in the order of mapping.map", item: [["mu", "floats", { length: 3, unit: "m", required: true, meaning: "position (x, y, z)" }], ["direction", "floats", { length: 3, default: [0, 0, 1], meaning: "where the microphone points" }]] }],
  ],
  sst: [
    ["mode", "string", { choices: ["kalman", "particle"], default: "kalman", meaning: "filter that follows a source" }],
    ["N_prob", "int", { unit: "hops", min: 1, max: 1000000, default: 5, meaning: "length of the probation" }],
    ["theta_new", "float", { min: 0, max: 1, default: 0.9, meaning: "probability over which a track is created" }],
    ["target", "list", { meaning: "directions that are always followed", item: [["tag", "string", { default: "", meaning: "its name in the tracks" }], ["x", "float", { default: 0, meaning: "direction" }]] }],
  ],
};

const kFirst = {
  raw: { fS: 16000, nChannels: 6, interface: { type: "soundcard_name" } },
  mapping: { map: [2, 3, 4, 5] },
  general: { mics: [{ mu: [-0.032, 0, 0] }, { mu: [0, -0.032, 0] }, { mu: [0.032, 0, 0] }, { mu: [0, 0.032, 0] }] },
  sst: { N_prob: 8 },
};

function write(value, indent = "") {
  if (Array.isArray(value)) {
    if (value.some((one) => typeof one === "object")) return `(\n${value.map((one) => `${indent}  ${write(one, `${indent}  `)}`).join(",\n")}\n${indent})`;
    return `(${value.join(", ")})`;
  }
  if (typeof value === "object") return `{ ${Object.entries(value).map(([key, one]) => `${key} = ${write(one, indent)};`).join(" ")} }`;
  return JSON.stringify(value);
}

/** The fake cannot read libconfig: it remembers what each text of its own said. */
const known = new Map();

function textOf(model) {
  const lines = ["# Seeed ReSpeaker USB Mic Array v2.0: four microphones on a circle of 64 mm.", ""];
  for (const [section, keys] of Object.entries(model)) {
    lines.push(`${section}: {`);
    for (const [key, value] of Object.entries(keys)) lines.push(`  ${key} = ${write(value, "  ")};`);
    lines.push("};", "");
  }
  const text = lines.join("\n");
  known.set(text, JSON.stringify(model));
  return text;
}

function modelOf(text) {
  const broken = text.split("\n").findIndex((line) => line.includes("!!"));
  if (broken >= 0) throw Object.assign(new Error("syntax"), { code: "invalid", data: { faults: [{ line: broken + 1, severity: "error", what: "syntax error: an expression was expected" }] } });
  const model = JSON.parse(known.get(text) ?? JSON.stringify(kFirst));
  const typed = /N_prob = (\d+)/.exec(text);
  if (typed && !known.has(text)) model.sst.N_prob = Number(typed[1]);
  return model;
}

function describe([key, kind, more], value, path, text) {
  const at = `${path}.${key}`;
  const line = text.split("\n").findIndex((one) => one.trim().startsWith(`${key} =`)) + 1;
  const field = { path: at, key, kind, ...more, written: value !== undefined, value: value ?? more.default ?? null, line: value === undefined ? null : line };
  if (kind === "group") return { ...field, fields: more.fields.map((one) => describe(one, value?.[one[0]], at, text)) };
  if (kind === "list") {
    return {
      ...field,
      item: more.item.map((one) => describe(one, undefined, `${at}[]`, text)),
      items: (value ?? []).map((item, i) => more.item.map((one) => describe(one, item[one[0]], `${at}[${i}]`, text))),
    };
  }
  return field;
}

function put(model, path, value) {
  const steps = path.match(/[^.[\]]+/g).map((step) => (/^\d+$/.test(step) ? Number(step) : step));
  let place = model;
  steps.slice(0, -1).forEach((step, i) => {
    place = place[step] ??= typeof steps[i + 1] === "number" ? [] : {};
  });
  const last = steps.at(-1);
  if (value !== null) place[last] = value;
  else if (Array.isArray(place)) place.splice(last, 1);
  else delete place[last];
}

function faultsOf(text) {
  const model = modelOf(text);
  const faults = [];
  const line = (word) => text.split("\n").findIndex((one) => one.includes(word)) + 1;
  if (model.sst?.N_prob > 1000) faults.push({ path: "sst.N_prob", line: line("N_prob"), severity: "error", what: "is 5000, is at most 1000 with this hop" });
  if (model.general.mics.length < 2) faults.push({ path: "general.mics", line: line("mics"), severity: "error", what: "two microphones or more are needed" });
  return faults;
}

export function errorMap() {
  const directions = [];
  const degrees = [];
  for (let el = 0; el < 90; el += 6) {
    for (let az = -180; az < 180; az += 6 / Math.max(0.1, Math.cos((el * Math.PI) / 180))) {
      const [a, e] = [(az * Math.PI) / 180, (el * Math.PI) / 180];
      directions.push([Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)]);
      degrees.push(1 + 12 * Math.exp(-el / 14));
    }
  }
  return { directions, degrees };
}

/** Methods for `FakeDaemon.methods`, and `applied`: every text that was put into the place of the running one. */
export function fakeConfig() {
  const state = { text: textOf(kFirst), previous: null, applied: [], dirty: false };
  const methods = {
    "config.get": () => ({ text: state.text, name: "respeaker_usb_4_mic", hash: "9f86d081", dirty: state.dirty, previous: state.previous !== null }),
    "config.form": ({ text }) => {
      const model = modelOf(text ?? state.text);
      return { sections: Object.entries(kFields).map(([name, fields]) => ({ name, fields: fields.map((field) => describe(field, model[name]?.[field[0]], name, text)) })) };
    },
    "config.check": ({ text }) => {
      try {
        const faults = faultsOf(text);
        return { faults, plan: "Array\n  microphones     4, in a plane\n  aperture        64.0 mm; closest two 45.3 mm\n", effect: text === state.text ? "none" : "restart" };
      } catch (error) {
        return { faults: error.data.faults, plan: "", effect: "none" };
      }
    },
    "config.edit": ({ text, changes }) => {
      const model = modelOf(text);
      for (const { path, value } of changes) put(model, path, value);
      return { text: textOf(model), faults: [] };
    },
    "config.apply": ({ text }) => {
      const faults = faultsOf(text);
      if (faults.length > 0) throw Object.assign(new Error("faults"), { code: "invalid", data: { faults } });
      Object.assign(state, { previous: state.text, text, dirty: true });
      state.applied.push(text);
      return { effect: "restart" };
    },
    "config.revert": () => {
      Object.assign(state, { text: state.previous, previous: null });
      return { effect: "restart" };
    },
    "config.save": ({ name }) => {
      state.dirty = false;
      return { file: `/etc/odas/${name ?? "respeaker_usb_4_mic"}.cfg` };
    },
    "arrays.list": () => [{ name: "minidsp_uma16", title: "miniDSP UMA-16 (v1 and v2)" }, { name: "respeaker_usb_4_mic", title: "Seeed ReSpeaker USB Mic Array v2.0" }],
    "arrays.get": () => ({ text: textOf(kFirst) }),
    "array.check": ({ text }) => {
      const { mics } = modelOf(text).general;
      return { mics, aperture: 0.064, aliasing_hz: 3790, aliasing_hz_worst: 2680, pairs: (mics.length * (mics.length - 1)) / 2, pairs_used: 6, scans: [], flat: true, ambiguous: [], faults: [], error_map: errorMap(), text: "" };
    },
    "devices.list": () => [
      { interface: "soundcard_name", name: "hw:CARD=ArrayUAC10,DEV=0", title: "ReSpeaker 4 Mic Array (UAC1.0)", channels: [6], rates: [16000], formats: ["S16_LE"], raw: "" },
      { interface: "soundcard_name", name: "hw:CARD=PCH,DEV=0", title: "HDA Intel PCH", channels: [2], rates: [44100, 48000], formats: ["S16_LE", "S32_LE"], raw: "" },
    ],
  };
  return { state, methods };
}
