import { expect, test } from "vitest";
import type { Vec3, ViewInfo } from "../../src/engine/types";
import { carriedDirection, carriedLights, carriedPoint, frameOf } from "../../src/stage/carried-lights";
import { framed, orbited, panned, poseOf, zoomed, type Pose } from "../../src/stage/camera";
import { pixelRay, pixelToWorld, worldToPixel } from "../../src/stage/projection";
import { cross, dot, length, rounded, subtract, unit } from "../../src/stage/vector";

const view = (part: Partial<ViewInfo> = {}): ViewInfo => ({
  projection: "perspective",
  eye: [0, 0, 5],
  target: [0, 0, 0],
  right: [1, 0, 0],
  up: [0, 1, 0],
  forward: [0, 0, -1],
  near: 1,
  far: 10,
  pixelsPerUnit: 500,
  width: 800,
  height: 600,
  lower: [-1, -1, -1],
  upper: [1, 1, 1],
  ...part,
});
const close = (a: Vec3, b: Vec3, digits = 9) => a.forEach((x, i) => expect(x).toBeCloseTo(b[i]!, digits));

test("a point of the world is where the perspective puts it", () => {
  expect(worldToPixel(view(), [1, 1, 0])).toEqual({ x: 500, y: 200, depth: 5 });
  expect(worldToPixel(view(), [1, 1, -5])).toEqual({ x: 450, y: 250, depth: 10 });
  expect(worldToPixel(view(), [0, 0, 6])).toBeUndefined();
});

test("parallel rays do not know the distance", () => {
  const v = view({ projection: "orthographic", pixelsPerUnit: 100 });
  expect(worldToPixel(v, [1, 1, -50])).toMatchObject({ x: 500, y: 200 });
  expect(pixelRay(v, 500, 200)).toEqual({ origin: [1, 1, 5], direction: [0, 0, -1] });
});

test("pixels go back to the world", () => {
  for (const v of [view(), view({ projection: "orthographic", pixelsPerUnit: 80 })]) {
    const point: Vec3 = [0.3, -1.2, 0.7];
    const at = worldToPixel(v, point)!;
    close(pixelToWorld(v, at.x, at.y, at.depth), point);
  }
});

test("an orbit keeps distance and target, and turns by the angle", () => {
  const start = poseOf(view(), undefined);
  const quarter = orbited(start, Math.PI / 2, 0);
  expect(length(quarter.eye)).toBeCloseTo(5, 9);
  expect(quarter.eye[1]).toBeCloseTo(0, 9);
  expect(Math.abs(quarter.eye[0])).toBeCloseTo(5, 9);
  const above = orbited(start, 0, Math.PI / 6);
  close(above.eye, [0, 2.5, 5 * Math.cos(Math.PI / 6)]);
});

test("an orbit stops before the pole, and leaves it again", () => {
  const top = orbited(poseOf(view(), undefined), 0, 3);
  expect(top.eye[1]).toBeGreaterThan(4.99);
  expect(dot(top.up, unit(subtract(top.target, top.eye)))).toBeCloseTo(0, 9);
  expect(orbited(top, 0, -0.5).eye[1]).toBeLessThan(4.5);
});

test("from straight above the image's up says where an orbit goes", () => {
  const v = view({ eye: [0, 5, 0], forward: [0, -1, 0], up: [0, 0, -1], right: [1, 0, 0] });
  const lower = orbited(poseOf(v, undefined), 0, -0.4);
  expect(lower.eye[2]).toBeGreaterThan(1);
  expect(lower.eye[0]).toBeCloseTo(0, 6);
});

test("panning moves eye and target alike, along the image", () => {
  const moved = panned(poseOf(view(), undefined), 2, 1);
  close(moved.eye, [2, 1, 5]);
  close(moved.target, [2, 1, 0]);
});

test("zooming keeps the point under the pointer", () => {
  const start = poseOf(view(), undefined);
  const point: Vec3 = [1.5, -0.5, 0];
  const after = zoomed(start, 0.5, point);
  const before = worldToPixel(view(), point)!;
  const now = worldToPixel(view({ eye: after.eye, target: after.target }), point)!;
  expect(now.x).toBeCloseTo(before.x, 9);
  expect(now.y).toBeCloseTo(before.y, 9);
  expect(length(subtract(after.eye, after.target))).toBeCloseTo(2.5, 9);
});

test("an orthographic zoom changes the height and keeps the point, too", () => {
  const v = view({ projection: "orthographic", pixelsPerUnit: 100 });
  const point: Vec3 = [2, 1, 0];
  const after = zoomed(poseOf(v, undefined), 0.5, point);
  expect(after.height).toBe(3);
  const before = worldToPixel(v, point)!;
  const now = worldToPixel({ ...v, eye: after.eye, pixelsPerUnit: 200 }, point)!;
  expect(now.x).toBeCloseTo(before.x, 9);
  expect(now.y).toBeCloseTo(before.y, 9);
});

test("framing brings every corner of the box into the picture, and wastes little", () => {
  const fov = 42;
  const lower: Vec3 = [-3, 0, -2];
  const upper: Vec3 = [4, 3, 2];
  for (const aspect of [0.5, 1, 2.2]) {
    const pose = framed(orbited(poseOf(view(), undefined), 0.7, 0.4), lower, upper, fov, aspect);
    const forward = unit(subtract(pose.target, pose.eye));
    const v = view({
      eye: pose.eye,
      target: pose.target,
      forward,
      up: pose.up,
      right: unit(cross(forward, pose.up)),
      width: 600 * aspect,
      pixelsPerUnit: 300 / Math.tan((fov * Math.PI) / 360),
    });
    let reach = 0;
    for (let corner = 0; corner < 8; corner++) {
      const at = worldToPixel(v, [corner & 1 ? 4 : -3, corner & 2 ? 3 : 0, corner & 4 ? 2 : -2])!;
      reach = Math.max(reach, Math.abs(at.x / v.width - 0.5) * 2, Math.abs(at.y / v.height - 0.5) * 2);
    }
    expect(reach).toBeLessThan(1);
    expect(reach).toBeGreaterThan(0.85);
  }
});

test("a light that is fixed to the camera stays the same in the camera's eyes", () => {
  const start: Pose = poseOf(view(), undefined);
  const end = panned(orbited(start, 1.1, 0.3), 0.4, -2);
  const from = frameOf(start);
  const to = frameOf(end);
  const inside = (point: Vec3, frame: typeof from) => frame.axes.map((axis) => dot(subtract(point, frame.origin), axis)) as Vec3;
  const light: Vec3 = [1, 2, 3];
  close(inside(carriedPoint(light, from, to), to), inside(light, from));
  const way: Vec3 = [0.2, -1, 0.4];
  expect(length(carriedDirection(way, from, to))).toBeCloseTo(length(way), 9);
  const scene = {
    objects: [],
    lights: [{ type: "point", position: light }, { type: "spot", position: light, direction: way }, { type: "directional" }],
  };
  expect(carriedLights(scene, [0], from, to).map(([path]) => path)).toEqual([["lights", 0, "position"]]);
  expect(carriedLights(scene, [1, 2, 9], from, to)).toHaveLength(3);
  close(carriedLights(scene, [0], from, from)[0]![1] as Vec3, light, 4);
});

test("numbers that are written are short, and near what they were", () => {
  expect(rounded([1.23456789, 0.00000123, -3.5])).toEqual([1.23457, 0, -3.5]);
  expect(rounded([0, -0, 0])).toEqual([0, 0, 0]);
  expect(rounded([123456.789, 0, 1])).toEqual([123457, 0, 1]);
});
