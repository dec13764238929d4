// SPDX-License-Identifier: MIT
// The browser of the tests, and how it is started.
import { chromium } from "playwright-core";

const executablePath = process.env.ODAS_CHROMIUM ?? "/usr/bin/chromium";

/**
 * The last list of features counts: those that playwright leaves out, and the two pages that each new window makes behind its address
 * bar, which cost a second of processor for each test.
 */
const kWithout = [
  "AimEnabled", "AvoidUnnecessaryBeforeUnloadCheckSync", "DestroyProfileOnBrowserClose", "HttpsFirstBalancedModeAutoEnable", "HttpsUpgrades", "LensOverlay",
  "MediaRouter", "NetworkTimeServiceQuerying", "OptimizationHints", "PaintHolding", "PreconnectToSearch", "ThirdPartyStoragePartitioning",
  "WebUIOmniboxAimPopup", "WebUIOmniboxPopup",
];

const kCommon = ["--no-sandbox", `--disable-features=${kWithout.join(",")}`];

/** For sound: nothing takes the page's thread from it. */
export const kListening = [...kCommon, "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--autoplay-policy=no-user-gesture-required"];

/** WebGL is drawn by software; the page is not put together by WebGL as well, which would take most of the time of all tests. */
const kArguments = [...kListening, "--disable-gpu-compositing"];

/** `--disable-gpu` and no software: WebGL is missing. */
export const kNoWebGL = [...kCommon, "--disable-gpu", "--disable-software-rasterizer"];

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
