import { decode } from "fast-png";
import { expect, test } from "vitest";
import { forWindow } from "../../src/files/examples";
import { mergedScene } from "../../src/files/open";
import { pngOf } from "../../src/files/png";
import type { SceneDoc } from "../../src/engine/types";

test("a PNG holds the engine's bytes, those below a transparent pixel too", () => {
  const bytes = new Uint8ClampedArray([255, 1, 2, 0, 9, 200, 3, 128, 10, 20, 30, 255, 0, 0, 0, 1]);
  const read = decode(pngOf({ width: 2, height: 2, bytes }));
  expect(read).toMatchObject({ width: 2, height: 2, channels: 4, depth: 8 });
  expect([...read.data]).toEqual([...bytes]);
});

test("a file that changed on disk keeps the reader's camera and shading, and brings what is new", () => {
  const before: SceneDoc = { objects: [{ mesh: "a.obj" }], lights: [{ type: "point" }], shading: { lighting: "phong" } };
  const page: SceneDoc = { ...before, camera: { eye: [1, 2, 3] }, shading: { lighting: "ggx" }, ambient: [1, 1, 1] };
  const now: SceneDoc = { objects: [{ mesh: "b.obj" }], lights: [{ type: "spot" }], shading: { lighting: "lambert" }, camera: { fov: 20 } };
  expect(mergedScene(before, page, now)).toEqual({
    objects: [{ mesh: "b.obj" }],
    lights: [{ type: "spot" }],
    shading: { lighting: "ggx" },
    camera: { eye: [1, 2, 3] },
    ambient: [1, 1, 1],
  });
});

test("a file whose mesh alone changed leaves the scene as it is", () => {
  const before: SceneDoc = { objects: [{ mesh: "a.obj" }] };
  const page: SceneDoc = { objects: [{ mesh: "a.obj", material: "gold" }], ambient: [1, 0, 0] };
  expect(mergedScene(before, page, before)).toBe(page);
});

test("a key that the file dropped goes, unless the reader changed nothing else there", () => {
  const before: SceneDoc = { objects: [], fog: { density: 1 } };
  expect(mergedScene(before, before, { objects: [] })).toEqual({ objects: [] });
});

test("in a narrow window an example is seen as wide as it was made", () => {
  const made: SceneDoc = { objects: [], image: { width: 1200, height: 600, samples: 8 }, camera: { eye: [0, 0, 5], fov: 30 } };
  expect(forWindow(made, 3)).toEqual({ objects: [], image: { samples: 8 }, camera: { eye: [0, 0, 5], fov: 30 } });
  const narrow = forWindow(made, 0.5).camera!["fov"] as number;
  const across = (fov: number, aspect: number) => Math.tan((fov * Math.PI) / 360) * aspect;
  expect(across(narrow, 0.5)).toBeCloseTo(across(30, 2), 3);
  expect(forWindow({ objects: [], camera: { fov: 30 } }, 0.5).camera).toEqual({ fov: 30 });
});
