// SPDX-License-Identifier: MIT
// Both languages say everything, and no words stand in the code.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

const root = join(process.cwd(), "src");
const files = readdirSync(root, { recursive: true, encoding: "utf8" });

/** Keys and texts of one language of a dictionary file. */
function table(source: string, language: string): Map<string, string> {
  const begin = source.indexOf(`  ${language}: {`);
  const end = source.indexOf("\n  },", begin);
  return new Map([...source.slice(begin, end).matchAll(/^ {4}"?([\w]+)"?:\s*"((?:[^"\\]|\\.)*)",?$/gm)].map((match) => [match[1]!, match[2]!]));
}

for (const name of files.filter((one) => one.endsWith("texts.ts"))) {
  test(`${name} says the same in English and French`, () => {
    const source = readFileSync(join(root, name), "utf8");
    const [en, fr] = [table(source, "en"), table(source, "fr")];
    assert.ok(en.size > 3, "the dictionary was found");
    assert.deepEqual([...fr.keys()].sort(), [...en.keys()].sort());
    for (const [key, text] of en) {
      const values = (words: string) => [...words.matchAll(/\{\w+\}/g)].map(String).sort();
      assert.deepEqual(values(fr.get(key)!), values(text), key);
    }
  });
}

test("no words stand in the code of the pages", () => {
  const allowed = /^(ODAS|Studio|English|Français|S|A|B|x|y|z|dB|Hz)?$/;
  for (const name of files.filter((one) => one.endsWith(".tsx"))) {
    const source = readFileSync(join(root, name), "utf8").replace(/^\s*(\/\/|\*|\/\*).*$/gm, "");
    for (const [, words] of source.matchAll(/>([^<>{}()=;&|?]*[A-Za-z]{2}[^<>{}()=;&|?]*)<\//g)) {
      assert.match(words!.trim(), allowed, name);
    }
    for (const [, words] of source.matchAll(/\s(?:aria-label|title|placeholder|alt)="([^"]*[A-Za-z]{2}[^"]*)"/g)) {
      assert.match(words!, /^\/home\/|^$/, name);
    }
  }
});
