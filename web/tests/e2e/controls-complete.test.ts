// Every key of the engine's table of options has a control on the page, and a test of it.
import { readFileSync, readdirSync } from "node:fs";
import { expect, test } from "vitest";
import { kBenches, kByThemselves, kTables } from "./controls";
import { openLab, useBrowser } from "./lab";
import { optionTable } from "./operate";

useBrowser();

test("no key is without a test of its control", async () => {
  const lab = await openLab();
  const keys = [...(await optionTable(lab.page)).keys()];
  await lab.close();
  const tested = Object.values(kBenches).flatMap((benches) => benches.flatMap(({ controls }) => controls.map(({ key }) => key)));
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
