// SPDX-License-Identifier: MIT
// Sizes and lengths as people read them.

/** "1.4 MB": powers of 1000, two digits or more. */
export function bytes(count: number, number: (value: number, digits: number) => string): string {
  const units = ["B", "kB", "MB", "GB", "TB"];
  let value = count;
  let unit = 0;
  while (value >= 1000 && unit < units.length - 1) {
    value /= 1000;
    ++unit;
  }
  return `${number(value, unit > 0 && value < 100 ? 1 : 0)}\u00a0${units[unit]}`;
}

/** "3:07", "1:02:03", or with tenths "3:07.4". */
export function clock(seconds: number, tenths = false): string {
  const whole = Math.max(0, Math.floor((tenths ? Math.floor(seconds * 10 + 1e-6) / 10 : seconds)));
  const two = (value: number) => String(value).padStart(2, "0");
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor(whole / 60) % 60;
  const start = hours > 0 ? `${hours}:${two(minutes)}` : String(minutes);
  const tail = tenths ? `.${Math.floor(Math.max(0, seconds) * 10 + 1e-6) % 10}` : "";
  return `${start}:${two(whole % 60)}${tail}`;
}
