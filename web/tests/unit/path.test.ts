import { expect, test } from "vitest";
import { pathSteps, pathText, valueAt, withValue } from "../../src/state/path";

test("a path reads the same as text and as steps", () => {
  expect(pathSteps("lights[2].attenuation.linear")).toEqual(["lights", 2, "attenuation", "linear"]);
  expect(pathText(["lights", 2, "attenuation", "linear"])).toBe("lights[2].attenuation.linear");
  expect(pathText("objects[0].material.diffuse")).toBe("objects[0].material.diffuse");
});

test("a value is stated without touching what is elsewhere", () => {
  const before = { camera: { fov: 30 }, lights: [{ type: "point" }, { type: "spot" }] };
  const after = withValue(before, "lights[1].cutoff", 20);
  expect(after).toEqual({ camera: { fov: 30 }, lights: [{ type: "point" }, { type: "spot", cutoff: 20 }] });
  expect(before.lights[1]).toEqual({ type: "spot" });
  expect(after.camera).toBe(before.camera);
  expect(after.lights[0]).toBe(before.lights[0]);
});

test("tables that are always there vanish when they say nothing, others stay", () => {
  expect(withValue({ shading: { lighting: "phong" } }, "shading.lighting", undefined)).toEqual({});
  expect(withValue({ image: { tone: { exposure: 1 } } }, "image.tone.exposure", undefined)).toEqual({});
  expect(withValue({ fog: { density: 1 } }, "fog.density", undefined)).toEqual({ fog: {} });
});

test("a table takes the place of the switch that stood for it", () => {
  expect(withValue({ shadow: true }, "shadow.size", 512)).toEqual({ shadow: { size: 512 } });
});

test("taking away what is not there changes nothing at all", () => {
  const before = { shading: { crease: 30 } };
  expect(withValue(before, "shading.cull", undefined).shading).toBe(before.shading);
  expect(withValue(before, "camera.fov", undefined)).toEqual(before);
  const toggled = { shadow: true };
  expect(withValue(toggled, "shadow.size", undefined)).toEqual({ shadow: true });
});

test("a list loses its entry", () => {
  expect(withValue({ lights: [1, 2, 3] }, ["lights", 1], undefined)).toEqual({ lights: [1, 3] });
});

test("names with dots and of prototypes are keys like others", () => {
  const after = withValue({}, ["materials", "a.b", "diffuse"], [1, 0, 0]);
  expect(valueAt(after, ["materials", "a.b", "diffuse"])).toEqual([1, 0, 0]);
  expect(valueAt({}, "constructor")).toBeUndefined();
  const odd = withValue({ materials: {} }, ["materials", "__proto__"], { shininess: 3 });
  expect(Object.keys(odd.materials)).toEqual(["__proto__"]);
  expect(({} as Record<string, unknown>)["shininess"]).toBeUndefined();
});
