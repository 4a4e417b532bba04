// Every key of the engine's table of options has a control on the page, and a test of it.
import { readFileSync, readdirSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import type { Option } from "../../src/engine/types";
import { optionsIt, unitsIt, wordsIt } from "../../src/i18n/options-it";
import { kBenches, kByThemselves, kTables } from "./controls";
import { openLab, useBrowser } from "./lab";
import { optionTable } from "./operate";

useBrowser();

let table: Map<string, Option>;
beforeAll(async () => {
  const lab = await openLab();
  table = await optionTable(lab.page);
  await lab.close();
});

const tested = Object.values(kBenches).flatMap((benches) => benches.flatMap(({ controls }) => controls.map(({ key }) => key)));

test("no key is without a test of its control", () => {
  const keys = [...table.keys()];
  const all = [...tested, ...Object.keys(kByThemselves), ...kTables];
  expect(
    keys.filter((key) => !all.includes(key)),
    "keys of the engine that no test knows",
  ).toEqual([]);
  expect(
    all.filter((key) => !keys.includes(key)),
    "keys that the engine does not know",
  ).toEqual([]);
  expect(
    kTables.filter((table) => !tested.some((key) => key.startsWith(`${table}.`))),
    "tables without a key",
  ).toEqual([]);
});

test("each bench and each test that is named is there", () => {
  const folder = new URL(".", import.meta.url);
  const files = readdirSync(folder).filter((name) => /^controls-.*\.test\.ts$/.test(name));
  const text = files.map((name) => readFileSync(new URL(name, folder), "utf8")).join("\n");
  for (const name of new Set(Object.values(kByThemselves))) {
    expect(text).toContain(`test("${name}"`);
  }
  for (const name of Object.keys(kBenches)) {
    expect(text).toContain(`testBenches(lab, kBenches.${name})`);
  }
});

test("each control speaks Italian", () => {
  const missing = tested.flatMap((key) => {
    const { words, unit } = table.get(key)!;
    const of = key.replace(/^materials\.\*\.(lighting|cull)$/, "shading.$1");
    return [
      ...(optionsIt[key] ? [] : [key]),
      ...words.map(({ word }) => `${of}: ${word}`).filter((word) => !wordsIt[word]),
      ...(unit === "" || unitsIt[unit] ? [] : [`unit ${unit}`]),
    ];
  });
  expect(missing).toEqual([]);
});
