import { afterEach, beforeEach, expect, test, vi } from "vitest";
import {
  amend,
  at,
  attachedLights,
  beginDrag,
  canRedo,
  canUndo,
  editLab,
  isDragging,
  pausingDrag,
  redo,
  resetScene,
  scene,
  undo,
  update,
  updateAll,
} from "../../src/state/scene";

beforeEach(() => {
  vi.useFakeTimers();
  resetScene({ objects: [{ mesh: "primitive:cube" }] });
});
afterEach(() => vi.useRealTimers());

test("every change can be undone and done again", () => {
  update("shading.lighting", "lambert");
  update("camera.fov", 30);
  undo();
  expect(scene.value).toEqual({ objects: [{ mesh: "primitive:cube" }], shading: { lighting: "lambert" } });
  undo();
  expect(scene.value).toEqual({ objects: [{ mesh: "primitive:cube" }] });
  expect(canUndo.value).toBe(false);
  redo();
  redo();
  expect(scene.value.camera).toEqual({ fov: 30 });
  expect(canRedo.value).toBe(false);
});

test("a drag is one step, however long it takes", () => {
  const end = beginDrag();
  update("camera.fov", 30);
  vi.advanceTimersByTime(5000);
  update("camera.fov", 35);
  update("camera.fov", 40);
  end();
  undo();
  expect(scene.value.camera).toBeUndefined();
});

test("two drags of the same place are two steps", () => {
  for (const fov of [30, 40]) {
    const end = beginDrag();
    update("camera.fov", fov);
    end();
  }
  undo();
  expect(scene.value.camera).toEqual({ fov: 30 });
});

test("typing is one step while it does not pause", () => {
  update("camera.fov", 3);
  vi.advanceTimersByTime(300);
  update("camera.fov", 31);
  vi.advanceTimersByTime(2000);
  update("camera.fov", 40);
  undo();
  expect(scene.value.camera).toEqual({ fov: 31 });
  undo();
  expect(scene.value.camera).toBeUndefined();
});

test("different places are different steps at once", () => {
  update("camera.fov", 30);
  update("shading.cull", "back");
  undo();
  expect(scene.value).toEqual({ objects: [{ mesh: "primitive:cube" }], camera: { fov: 30 } });
});

test("a new change forgets what was undone", () => {
  update("camera.fov", 30);
  undo();
  update("camera.fov", 50);
  expect(canRedo.value).toBe(false);
});

test("stating what is stated already is no step", () => {
  update("camera.fov", 30);
  const before = scene.value;
  update("camera.fov", 30);
  expect(scene.value).toBe(before);
  undo();
  expect(canUndo.value).toBe(false);
});

test("several places change in one step", () => {
  updateAll(
    [
      ["camera.eye", [1, 2, 3]],
      ["camera.target", [0, 0, 0]],
    ],
    "camera",
  );
  undo();
  expect(scene.value.camera).toBeUndefined();
});

test("lights that are fixed to the camera are undone with the rest", () => {
  editLab((doc) => ({ scene: { ...doc.scene, lights: [{}] }, attached: [0] }));
  expect(attachedLights.value).toEqual([0]);
  undo();
  expect(attachedLights.value).toEqual([]);
});

test("what is amended belongs to the step before", () => {
  update("camera.view", "top");
  amend((doc) => ({ ...doc, scene: { ...doc.scene, ambient: [1, 1, 1] } }));
  undo();
  expect(scene.value).toEqual({ objects: [{ mesh: "primitive:cube" }] });
});

test("a signal of a place changes only with that place", () => {
  const seen: unknown[] = [];
  const stop = at("shading.lighting").subscribe((value) => seen.push(value));
  update("camera.fov", 30);
  update("shading.lighting", "ggx");
  update("camera.fov", 31);
  stop();
  expect(seen).toEqual([undefined, "ggx"]);
});

test("a gesture without an end is over after a moment", () => {
  const pause = pausingDrag();
  pause();
  vi.advanceTimersByTime(100);
  pause();
  vi.advanceTimersByTime(100);
  expect(isDragging.value).toBe(true);
  vi.advanceTimersByTime(200);
  expect(isDragging.value).toBe(false);
});
