// SPDX-License-Identifier: MIT
// Says whom a Studio hears, and keeps each voice as a WAV: node studio_client.mjs [ADDRESS [SECONDS]], Ctrl-C ends.
// Wants Node 22, or Node 20 with --experimental-websocket; but for the files it works in a page as well.
import { writeFileSync } from "node:fs";

const address = new URL(process.argv[2] ?? "http://127.0.0.1:8080/"); // or with ?token=..., as the daemon prints it
const seconds = Number(process.argv[3] ?? Infinity);
address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
address.pathname = "/api/v1/live";

const voices = new Map(); // track: { rate, next: the sample that comes next, parts }
const socket = new WebSocket(address);
socket.binaryType = "arraybuffer";
socket.onopen = () => subscribe();
socket.onerror = () => console.error(`${address} is not there, or wants a token`);
socket.onclose = finish;
socket.onmessage = ({ data }) => (typeof data === "string" ? hear(JSON.parse(data)) : keep(data));
process.on("SIGINT", () => socket.close());
if (seconds < Infinity) setTimeout(() => socket.close(), 1000 * seconds);

function subscribe() {
  const audio = [...voices.keys()].slice(-8).map((track) => ({ stream: "separated", track }));
  socket.send(JSON.stringify({ type: "subscribe", topics: { hops: 10 }, audio }));
}

function hear(message) {
  if (message.type !== "hops") return; // what is not known is passed over
  for (const hop of message.hops) {
    for (const [, track, x, y] of hop.tracks) {
      if (voices.has(track)) continue;
      console.log(`source ${track} at azimuth ${((180 / Math.PI) * Math.atan2(y, x)).toFixed(0)}`);
      voices.set(track, { rate: 0, next: 0, parts: [] });
      subscribe();
    }
  }
}

function keep(data) {
  const head = new DataView(data);
  const count = head.getUint16(20, true);
  const voice = voices.get(head.getUint32(4, true));
  if (head.getUint8(0) !== 1 || count === 0 || voice === undefined) return;
  const index = Number(head.getBigUint64(8, true));
  if (voice.rate === 0) Object.assign(voice, { rate: head.getUint32(16, true), next: index });
  voice.parts.push(Buffer.alloc(2 * (index - voice.next)), Buffer.from(data, 24)); // what was lost is silence
  voice.next = index + count;
}

function finish() {
  for (const [track, { rate, parts }] of voices) {
    const sound = Buffer.concat(parts);
    const head = Buffer.from("RIFF....WAVEfmt \x10...\x01.\x01.............data....", "latin1");
    head.writeUInt32LE(36 + sound.length, 4);
    [16, 0x10001, rate, 2 * rate, 0x100002].forEach((value, i) => head.writeUInt32LE(value, 16 + 4 * i));
    head.writeUInt32LE(sound.length, 40);
    if (rate > 0) writeFileSync(`voice_${track}.wav`, Buffer.concat([head, sound]));
  }
  process.exit(voices.size > 0 ? 0 : 1);
}
