import { expect, test } from "vitest";
import { defaultValue, fromShare, isAllowed, niceSize, sliderRange, toShare } from "../../src/controls/defaults";
import type { Option } from "../../src/engine/types";

const option = (part: Partial<Option>): Option => ({
  key: "k",
  flag: "",
  help: "",
  unit: "",
  kind: "number",
  optional: false,
  default: "0",
  words: [],
  ...part,
});

test("defaults are values where they are fixed, and nothing where they are chosen", () => {
  expect(defaultValue(option({ default: "42" }))).toBe(42);
  expect(defaultValue(option({ default: "frames the whole scene" }))).toBeUndefined();
  expect(defaultValue(option({ default: "" }))).toBeUndefined();
  expect(defaultValue(option({ kind: "color", default: "0.1,0.1,0.12" }))).toEqual([0.1, 0.1, 0.12]);
  expect(defaultValue(option({ kind: "vector", default: "chosen by `view`" }))).toBeUndefined();
  expect(defaultValue(option({ kind: "boolean", default: "false; true for a bare mesh" }))).toBe(false);
  expect(defaultValue(option({ kind: "triple", default: "1" }))).toEqual([1, 1, 1]);
  expect(defaultValue(option({ kind: "terms", default: "ambient,diffuse" }))).toEqual(["ambient", "diffuse"]);
  expect(defaultValue(option({ kind: "word", default: "phong", words: [{ word: "phong", help: "" }] }))).toBe("phong");
  expect(defaultValue(option({ kind: "word", default: "that of `shading`", words: [{ word: "phong", help: "" }] }))).toBeUndefined();
});

test("only numbers of the range are taken", () => {
  const fov = option({ minimum: 0, maximum: 180, minimumOpen: true, maximumOpen: true });
  expect([0, 1e-9, 179.9, 180].map((n) => isAllowed(fov, n))).toEqual([false, true, true, false]);
  const samples = option({ kind: "integer", allowed: [1, 2, 4, 8, 16] });
  expect([2, 3, 16].map((n) => isAllowed(samples, n))).toEqual([true, false, true]);
  expect(isAllowed(option({ kind: "integer", minimum: 0 }), 1.5)).toBe(false);
  expect(isAllowed(option({}), NaN)).toBe(false);
});

test("a slider's ends are where its values are, and it goes back and forth", () => {
  for (const range of [
    { from: -6, to: 6, scale: "linear" },
    { from: 0.01, to: 100, scale: "log" },
    { from: 0, to: 1000, scale: "log" },
  ] as const) {
    expect(fromShare(range, 0)).toBeCloseTo(range.from, 9);
    expect(fromShare(range, 1)).toBeCloseTo(range.to, 9);
    for (const share of [0.1, 0.4, 0.9]) {
      expect(toShare(range, fromShare(range, share))).toBeCloseTo(share, 9);
    }
  }
  expect(toShare({ from: 0, to: 1000, scale: "log" }, 0)).toBe(0);
});

test("endless options have sliders of the scene's size, finite ones their own", () => {
  expect(sliderRange("fog.end", option({}), 10)).toEqual({ from: 0, to: 60, scale: "linear" });
  expect(sliderRange("shading.crease", option({ minimum: 0, maximum: 180 }), 10)).toEqual({ from: 0, to: 180, scale: "linear" });
  expect(sliderRange("camera.eye", option({}), 10)).toBeUndefined();
  expect([0.0134, 3, 12, 90, 0, NaN].map(niceSize)).toEqual([0.01, 2, 10, 100, 1, 1]);
});
