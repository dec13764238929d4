// SPDX-License-Identifier: MIT
// The browser of the tests, and how it is started.
import { chromium } from "playwright-core";

const executablePath = process.env.ODAS_CHROMIUM ?? "/usr/bin/chromium";

/** For sound: nothing takes the page's thread from it. */
export const kListening = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--autoplay-policy=no-user-gesture-required"];

/** WebGL is drawn by software; the page is not put together by WebGL as well, which would take most of the time of all tests. */
const kArguments = [...kListening, "--disable-gpu-compositing"];

/** `--disable-gpu` and no software: WebGL is missing. */
export const kNoWebGL = ["--no-sandbox", "--disable-gpu", "--disable-software-rasterizer"];

/** A browser of one's own, for what a shared one cannot show. */
export function launch(args = kArguments) {
  return chromium.launch({ executablePath, args });
}

/** One for many programs: `wsEndpoint()` says where. */
export function launchServer() {
  return chromium.launchServer({ executablePath, args: kArguments });
}

export function connect(endpoint) {
  return chromium.connect(endpoint);
}
