// SPDX-License-Identifier: MIT
import "./styles/index.css";

import { render } from "preact";

import { App } from "./app";
import { Listener } from "./audio/listener";
import { followLanguage } from "./i18n/follow";
import { followPlace } from "./shell/router";
import { followTheme } from "./shell/theme";
import { Connection, liveUrl } from "./socket/socket";
import { Store } from "./store/store";
import type { Studio } from "./studio";

const store = new Store();
const connection = new Connection(store, liveUrl(location));
const listener = new Listener((wishes) => connection.setAudio(wishes));
connection.onAudio = (block) => listener.push(block);
store.epoch.subscribe(() => listener.restart());

const studio: Studio = {
  store,
  call: (method, params) => connection.rpc.call(method, params),
  setAudio: (wishes) => connection.setAudio(wishes),
  setPower: (rate) => connection.setPower(rate),
  listener,
};

followTheme();
followPlace();
followLanguage();
connection.open();
setInterval(() => store.tick(), 250);
addEventListener("online", () => connection.retry());
render(<App studio={studio} retry={() => connection.retry()} />, document.getElementById("app")!);
