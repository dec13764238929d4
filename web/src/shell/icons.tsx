// SPDX-License-Identifier: MIT
// Small line drawings, 24 x 24, in the colour of the text. They are decoration: the control that holds one has a name.

const kPaths = {
  eye: "M2 12s3.6-6.5 10-6.5S22 12 22 12s-3.6 6.5-10 6.5S2 12 2 12Z M12 15a3 3 0 1 0 0-6 3 3 0 0 0 0 6Z",
  eyeOff: "M4 4l16 16 M9.5 5.8A9.7 9.7 0 0 1 12 5.5c6.4 0 10 6.5 10 6.5a17 17 0 0 1-3.3 4 M6 7.5A16.5 16.5 0 0 0 2 12s3.6 6.5 10 6.5c1.6 0 3-.4 4.2-1",
  ear: "M4 10v4h3.5l4.5 4V6L7.5 10H4Z M16 9a4.2 4.2 0 0 1 0 6 M18.6 6.5a8 8 0 0 1 0 11",
  record: "M12 12m-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0",
  stop: "M7 7h10v10H7Z",
  play: "M8 5.5v13l11-6.5Z",
  pause: "M8 5.5v13 M16 5.5v13",
  sun: "M12 16.5a4.5 4.5 0 1 0 0-9 4.5 4.5 0 0 0 0 9Z M12 2.5v2 M12 19.5v2 M2.5 12h2 M19.5 12h2 M5.3 5.3l1.4 1.4 M17.3 17.3l1.4 1.4 M18.7 5.3l-1.4 1.4 M6.7 17.3l-1.4 1.4",
  sliders: "M4 7h10 M18 7h2 M4 17h2 M10 17h10 M16 9a2 2 0 1 0 0-4 2 2 0 0 0 0 4Z M8 19a2 2 0 1 0 0-4 2 2 0 0 0 0 4Z",
  help: "M9.2 9.2a2.9 2.9 0 1 1 4.3 2.5c-1 .6-1.5 1.1-1.5 2.3 M12 17.5v.1 M12 21.5a9.5 9.5 0 1 0 0-19 9.5 9.5 0 0 0 0 19Z",
  pin: "M12 21s6.5-6 6.5-11.2A6.5 6.5 0 0 0 5.5 9.8C5.5 15 12 21 12 21Z M12 12.2a2.4 2.4 0 1 0 0-4.8 2.4 2.4 0 0 0 0 4.8Z",
  mute: "M4 10v4h3.5l4.5 4V6L7.5 10H4Z M16 9.5l5 5 M21 9.5l-5 5",
  follow: "M12 8.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7Z M12 2.5v4 M12 17.5v4 M2.5 12h4 M17.5 12h4",
  link: "M10 13.5a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1 M14 10.5a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",
  heat: "M12 3c1 3.5 5.5 5.5 5.5 10.5a5.5 5.5 0 0 1-11 0c0-2 1-3.5 2-4.5.3 1.5 1 2.3 2 2.5C10 8.5 10.5 5.5 12 3Z",
  close: "M6 6l12 12 M18 6L6 18",
  power: "M12 3v8 M6.5 6.5a8 8 0 1 0 11 0",
  chevron: "M6 9.5l6 6 6-6",
  back: "M14.5 6l-6 6 6 6",
  forward: "M9.5 6l6 6-6 6",
} as const;

export type IconName = keyof typeof kPaths;

export function Icon({ name, filled = false }: { name: IconName; filled?: boolean }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true" fill={filled ? "currentColor" : "none"} stroke="currentColor" stroke-width="1.7" stroke-linecap="round" stroke-linejoin="round">
      <path d={kPaths[name]} />
    </svg>
  );
}
