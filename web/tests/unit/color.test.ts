import { expect, test } from "vitest";
import { decoded, encoded, picked, readColor, screenColor, writeLinear, writeText } from "../../src/controls/color";

test("sRGB's curve has the standard's values", () => {
  expect(decoded(0.5)).toBeCloseTo(0.21404114, 7);
  expect(encoded(0.18)).toBeCloseTo(0.46135612, 7);
  expect(decoded(0.04)).toBeCloseTo(0.04 / 12.92, 12);
  for (let i = 0; i <= 255; i++) {
    expect(encoded(decoded(i / 255)) * 255).toBeCloseTo(i, 8);
  }
});

test("lists are light itself, text is sRGB", () => {
  expect(readColor([0.5, 2, 0], true)).toEqual({ linear: [0.5, 2, 0], isText: false });
  expect(readColor("#ff8000", true)?.linear[1]).toBeCloseTo(decoded(128 / 255), 12);
  expect(readColor("#f80", true)?.linear).toEqual(readColor("#ff8800", true)?.linear);
  expect(readColor("color(srgb 0.5 0.25 1)", true)?.linear[0]).toBeCloseTo(0.21404114, 7);
});

test("with transfer none every number counts as it stands", () => {
  expect(readColor("color(srgb 0.5 0.25 1)", false)?.linear).toEqual([0.5, 0.25, 1]);
  expect(writeText([0.5, 0.25, 1], false)).toBe("color(srgb 0.5 0.25 1)");
});

test("alpha stands fourth", () => {
  expect(readColor("#00000080", true)?.alpha).toBeCloseTo(128 / 255, 12);
  expect(readColor("color(srgb 0 0 0 / 0.25)", true)?.alpha).toBe(0.25);
  expect(readColor([0, 0, 0, 0.5], true)?.alpha).toBe(0.5);
  expect(writeLinear([0, 0, 0], 0.5)).toEqual([0, 0, 0, 0.5]);
});

test("what is no colour is none", () => {
  for (const text of ["#12", "red", "color(srgb 1 2)", "color(srgb -1 0 0)", "rgb(1,2,3)", [1, 2], [1, "2", 3], null]) {
    expect(readColor(text, true)).toBeUndefined();
  }
});

test("another notation is the same colour", () => {
  for (const text of ["#d4a017", "#000000", "#0102fe"]) {
    expect(writeText(readColor(text, true)!.linear, true)).toBe(text);
  }
  const linear = readColor("color(srgb 0.633 0.727811 0.633)", true)!.linear;
  expect(writeText(linear, true)).toBe("color(srgb 0.633 0.727811 0.633)");
});

test("a screen shows bright colours at their hue, and picking keeps how bright they are", () => {
  expect(screenColor([4, 2, 0], true)).toBe(screenColor([1, 0.5, 0], true));
  expect(picked("#ffffff", [4, 2, 0], true)).toEqual([4, 4, 4]);
  expect(picked("#ffffff", [0.2, 0.1, 0], true)).toEqual([1, 1, 1]);
});
