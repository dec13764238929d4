// SPDX-License-Identifier: MIT
import "./styles/index.css";

import { render } from "preact";

import { App } from "./app";
import { AudioDesk } from "./audio/desk";
import { Listener } from "./audio/listener";
import { followLanguage } from "./i18n/follow";
import { followPlace } from "./shell/router";
import { followTheme } from "./shell/theme";
import { Connection, liveUrl } from "./socket/socket";
import { Store } from "./store/store";
import type { Studio } from "./studio";

const store = new Store();
const connection = new Connection(store, liveUrl(location));
const desk = new AudioDesk((wishes) => connection.setAudio(wishes));
const listener = new Listener((wishes) => desk.want("listener", wishes));
desk.listen((block) => listener.push(block));
connection.onAudio = (block) => desk.take(block);
store.epoch.subscribe(() => listener.restart());

const studio: Studio = {
  store,
  call: (method, params) => connection.rpc.call(method, params),
  setAudio: (wishes) => connection.setAudio(wishes),
  setPower: (rate) => connection.setPower(rate),
  listener,
  desk,
};

followTheme();
followPlace();
followLanguage();
connection.open();
setInterval(() => store.tick(), 250);
addEventListener("online", () => connection.retry());
render(<App studio={studio} retry={() => connection.retry()} />, document.getElementById("app")!);
