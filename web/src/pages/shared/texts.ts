// SPDX-License-Identifier: MIT
import { texts } from "../../i18n/i18n";

export const t = texts({
  en: {
    cancel: "Cancel",
    undo: "Undo",
    viewerOnly: "You are here as a viewer: you may look, listen and download, and change nothing.",
    offline: "There is no connection to the daemon. What you see here is as it was; the page tries again by itself.",
    play: "Play",
    pause: "Pause",
    download: "Download",
    missing: "This daemon does not offer this: it is older, or was built without it.",
    seconds: "{n} s",
  },
  fr: {
    cancel: "Annuler",
    undo: "Rétablir",
    viewerOnly: "Vous êtes ici en lecture seule : vous pouvez regarder, écouter et télécharger, sans rien changer.",
    offline: "Pas de connexion au démon. Ce qui est affiché date d’avant ; la page réessaie d’elle-même.",
    play: "Lire",
    pause: "Pause",
    download: "Télécharger",
    missing: "Ce démon n’offre pas cela : il est plus ancien, ou construit sans.",
    seconds: "{n} s",
  },
});
