// SPDX-License-Identifier: MIT
// A daemon that says what a test tells it to, behind the page's WebSocket.
import { hello, hops, kEngine } from "./fixtures.mjs";

export class FakeDaemon {
  /** Every message of the page, parsed. */
  heard = [];
  connections = 0;
  /** Commands and what they answer: a value, or a function of `params`; one that throws `{code, message}` is an error. */
  methods = {};
  /** What is said at each new connection. */
  greeting = [hello(), kEngine];
  refusing = false;
  t = 1;

  async attach(page) {
    await page.routeWebSocket("**/api/v1/live*", (socket) => {
      if (this.refusing) return socket.close();
      this.connections++;
      this.socket = socket;
      socket.onMessage((text) => this.#hear(JSON.parse(text)));
      for (const message of this.greeting) this.send(message);
    });
  }

  send(message) {
    this.socket?.send(Buffer.isBuffer(message) ? message : JSON.stringify(message));
  }

  /** Says `count` more hops. */
  hops(count, tracks, potentials) {
    const message = hops(this.t, count, tracks, potentials);
    this.t += count;
    this.send(message);
  }

  /** Says hops ten times a second until `stop`; `scene` may be changed meanwhile. */
  feed(scene) {
    this.hops(12, scene.tracks, scene.potentials);
    this.timer = setInterval(() => this.hops(12, scene.tracks, scene.potentials), 100);
    return scene;
  }

  stop() {
    clearInterval(this.timer);
  }

  /** Ends the connection; refuses new ones until `refusing` is false. */
  drop(refuse = false) {
    this.refusing = refuse;
    this.socket?.close();
    this.socket = undefined;
  }

  /** All commands of `method` so far. */
  calls(method) {
    return this.heard.filter((message) => message.method === method);
  }

  /** Resolves with the parameters of the first command of `method`. */
  async called(method) {
    for (let tries = 0; this.calls(method).length === 0; tries++) {
      if (tries > 200) throw new Error(`${method} was not called`);
      await new Promise((resolve) => setTimeout(resolve, 25));
    }
    return this.calls(method)[0].params;
  }

  get subscription() {
    return this.heard.findLast((message) => message.type === "subscribe");
  }

  #hear(message) {
    this.heard.push(message);
    if (message.method === undefined) return;
    const method = this.methods[message.method];
    try {
      const result = typeof method === "function" ? method(message.params) : (method ?? {});
      this.send({ type: "reply", id: message.id, result });
    } catch (error) {
      this.send({ type: "reply", id: message.id, error: { code: error.code ?? "failed", message: error.message, data: error.data } });
    }
  }
}
