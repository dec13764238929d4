// SPDX-License-Identifier: MIT
import { texts } from "../../i18n/i18n";

export const t = texts({
  en: {
    title: "Camera",
    none: "No camera is configured",
    noneNext: "Set studio.camera.url, with the numbers of the lens (fx, fy, cx, cy) and where it looks (rotation): the sources then stand in its picture.",
    toConfig: "To the configuration",
    failed: "The picture of the camera does not come",
    failedNext: "Is {url} reachable from this computer? The page tries again when you ask for it.",
    tryAgain: "Try again",
    distance: "Distance of the sources",
    far: "far away",
    metres: "{n} m",
    label: "Picture of the camera with {n} sources in it: {list}",
    labelNone: "Picture of the camera, no source in it",
    outside: "Not in the picture: {list}",
    source: "{id} at {az} / {el}",
  },
  fr: {
    title: "Caméra",
    none: "Aucune caméra n’est configurée",
    noneNext: "Donnez studio.camera.url, avec les nombres de l’objectif (fx, fy, cx, cy) et où elle regarde (rotation) : les sources se placent alors dans son image.",
    toConfig: "À la configuration",
    failed: "L’image de la caméra n’arrive pas",
    failedNext: "{url} est-elle joignable de cet ordinateur ? La page réessaie quand vous le demandez.",
    tryAgain: "Réessayer",
    distance: "Distance des sources",
    far: "au loin",
    metres: "{n} m",
    label: "Image de la caméra avec {n} sources : {list}",
    labelNone: "Image de la caméra, aucune source",
    outside: "Hors de l’image : {list}",
    source: "{id} à {az} / {el}",
  },
});
