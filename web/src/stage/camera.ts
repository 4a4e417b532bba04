// Moving the camera: from the view of a picture to the eye, target and up that the scene states. Orbits keep the horizon level, as turntables do.
import type { SceneDoc, Vec3, ViewInfo } from "../engine/types";
import { view } from "../state/picture";
import { effect } from "@preact/signals";
import { amend, attachedLights, scene, updateAll } from "../state/scene";
import { withValue, type Path } from "../state/path";
import { carriedLights, frameOf } from "./carried-lights";
import { pictureRect } from "./projection";
import { add, cross, dot, length, rounded, scaled, subtract, turned, unit } from "./vector";

/** A camera as it is being moved. */
export interface Pose {
  projection: ViewInfo["projection"];
  eye: Vec3;
  target: Vec3;
  /** of the image, unit, at right angles to the view */
  up: Vec3;
  /** the turntable's axis, unit */
  axis: Vec3;
  /** what an orthographic camera sees from bottom to top, world units */
  height: number;
}

const kSteepest = (89.5 * Math.PI) / 180;
const kMargin = 1.08;

const isVector = (value: unknown): value is Vec3 => Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === "number");

/** The pose that a picture shows. */
export function poseOf(v: ViewInfo, statedUp: unknown = scene.peek().camera?.["up"]): Pose {
  return {
    projection: v.projection,
    eye: v.eye,
    target: v.target,
    up: v.up,
    axis: isVector(statedUp) && length(statedUp) > 0 ? unit(statedUp) : [0, 1, 0],
    height: v.height / v.pixelsPerUnit,
  };
}

/** The pose that was written last, as long as the scene is the one that it made: pictures come later than keys. */
let written: { pose: Pose; scene: SceneDoc } | undefined;

/** The pose now: what was written last, else that of the latest picture. */
export function currentPose(): Pose | undefined {
  if (written && written.scene === scene.peek()) {
    return written.pose;
  }
  const v = view.peek();
  return v && poseOf(v);
}

/** World units that a CSS pixel spans at the target's depth. */
export function unitsPerPixel(pose: Pose): number {
  const height =
    pose.projection === "orthographic" ? pose.height : 2 * length(subtract(pose.eye, pose.target)) * Math.tan((fovOf() * Math.PI) / 360);
  return height / Math.max(1, pictureRect.peek().height);
}

/** The world's point at the target's depth under a place of the picture, CSS pixels. */
export function pointUnder(pose: Pose, x: number, y: number): Vec3 {
  const { width, height } = pictureRect.peek();
  const scale = unitsPerPixel(pose);
  return panned(pose, (x - width / 2) * scale, (height / 2 - y) * scale).target;
}

/** Turned around the target: to the right, and upwards, radians. */
export function orbited(pose: Pose, right: number, upwards: number): Pose {
  const { axis, target } = pose;
  const offset = subtract(pose.eye, target);
  const distance = length(offset);
  const forward = unit(scaled(offset, -1));
  const elevation = Math.asin(Math.max(-1, Math.min(1, -dot(forward, axis))));
  // Straight above or below, the image's up says where the camera looks from.
  const level = (a: Vec3): Vec3 => subtract(a, scaled(axis, dot(a, axis)));
  const flat = level(forward);
  const heading = length(flat) > 1e-4 ? unit(flat) : unit(level(scaled(pose.up, Math.sign(elevation) || 1)), [0, 0, -1]);
  const turnedHeading = turned(heading, axis, right);
  const raised = Math.max(-kSteepest, Math.min(kSteepest, elevation + upwards));
  const eye = add(target, add(scaled(turnedHeading, -distance * Math.cos(raised)), scaled(axis, distance * Math.sin(raised))));
  const side = unit(cross(turnedHeading, axis));
  return { ...pose, eye, up: unit(cross(side, unit(subtract(target, eye)))) };
}

/** Moved with its target along the image: to the right and upwards, world units. */
export function panned(pose: Pose, right: number, upwards: number): Pose {
  const forward = unit(subtract(pose.target, pose.eye));
  const shift = add(scaled(unit(cross(forward, pose.up)), right), scaled(pose.up, upwards));
  return { ...pose, eye: add(pose.eye, shift), target: add(pose.target, shift) };
}

/** Nearer (factor < 1) or farther; `around` is the world's point, at the target's depth, that stays where it is on the image. */
export function zoomed(pose: Pose, factor: number, around: Vec3 = pose.target): Pose {
  const towards = (a: Vec3): Vec3 => add(around, scaled(subtract(a, around), factor));
  if (pose.projection === "perspective") {
    return { ...pose, eye: towards(pose.eye), target: towards(pose.target) };
  }
  const shift = subtract(towards(pose.target), pose.target);
  return { ...pose, eye: add(pose.eye, shift), target: add(pose.target, shift), height: pose.height * factor };
}

/** All of a box in sight, seen from the same direction. fov of the image's height, degrees; aspect width by height. */
export function framed(pose: Pose, lower: Vec3, upper: Vec3, fov: number, aspect: number): Pose {
  const center = scaled(add(lower, upper), 0.5);
  const half = scaled(subtract(upper, lower), 0.5);
  const forward = unit(subtract(pose.target, pose.eye));
  const right = unit(cross(forward, pose.up));
  const tangentUp = Math.tan((fov * Math.PI) / 360);
  let distance = 0;
  let height = 0;
  for (let corner = 0; corner < 8; corner++) {
    const p: Vec3 = [corner & 1 ? half[0] : -half[0], corner & 2 ? half[1] : -half[1], corner & 4 ? half[2] : -half[2]];
    const across = Math.abs(dot(p, right));
    const up = Math.abs(dot(p, pose.up));
    distance = Math.max(distance, (kMargin * Math.max(up, across / aspect)) / tangentUp - dot(p, forward));
    height = Math.max(height, 2 * kMargin * Math.max(up, across / aspect));
  }
  if (pose.projection === "orthographic") {
    distance = Math.max(distance, 2 * length(half));
  }
  return { ...pose, target: center, eye: subtract(center, scaled(forward, distance || 1)), height: height || pose.height };
}

/** States a pose in the scene, as one step of undo with those before it. */
export function writePose(pose: Pose, key = "camera"): void {
  const before = currentPose();
  const size = Math.max(length(subtract(pose.eye, pose.target)), ...pose.target.map(Math.abs));
  const changes: [Path, unknown][] = [
    ["camera.eye", rounded(pose.eye, size)],
    ["camera.target", rounded(pose.target, size)],
  ];
  if (isVector(scene.peek().camera?.["up"])) {
    changes.push(["camera.up", scene.peek().camera?.["up"]]);
  }
  if (pose.projection === "orthographic") {
    changes.push(["camera.height", Number(pose.height.toPrecision(6))]);
  }
  if (before) {
    changes.push(...carriedLights(scene.peek(), attachedLights.peek(), frameOf(before), frameOf(pose)));
  }
  updateAll(changes, key);
  written = { pose, scene: scene.peek() };
}

/** Lights that are fixed to the camera follow it where only the next picture says where it is. */
function carryWithNextPicture(): void {
  const before = view.peek();
  if (!before || attachedLights.peek().length === 0) {
    return;
  }
  let isFirst = true;
  const stop = effect(() => {
    const after = view.value;
    if (isFirst || !after) {
      isFirst = false;
      return;
    }
    queueMicrotask(() => stop());
    amend((doc) => ({
      ...doc,
      scene: carriedLights(doc.scene, doc.attached, frameOf(poseOf(before)), frameOf(poseOf(after))).reduce(
        (changed, [path, value]) => withValue(changed, path, value),
        doc.scene,
      ),
    }));
  });
}

const kStanding = ["eye", "target", "up", "height", "near", "far"] as const;

/** One of the library's views, which frame the whole scene. */
export function showPreset(name: string): void {
  carryWithNextPicture();
  updateAll([...kStanding.map((key): [Path, unknown] => [`camera.${key}`, undefined]), ["camera.view", name]], "");
}

/** Perspective or orthographic, so that the target stays as large as it is. */
export function setProjection(projection: ViewInfo["projection"]): void {
  const v = view.peek();
  carryWithNextPicture();
  if (!v || v.projection === projection) {
    updateAll([["camera.projection", projection]], "");
    return;
  }
  const fov = fovOf();
  const tangent = Math.tan((fov * Math.PI) / 360);
  const away = subtract(v.eye, v.target);
  const isStated = isVector(scene.peek().camera?.["eye"]);
  const changes: [Path, unknown][] = [["camera.projection", projection]];
  if (projection === "orthographic") {
    changes.push(["camera.height", isStated ? Number((2 * length(away) * tangent).toPrecision(6)) : undefined]);
  } else {
    const distance = v.height / v.pixelsPerUnit / 2 / tangent;
    changes.push(["camera.height", undefined]);
    if (isStated) {
      changes.push(["camera.eye", rounded(add(v.target, scaled(unit(away), distance)))]);
    }
  }
  updateAll(changes, "");
}

/** Degrees, of the image's height. */
export function fovOf(): number {
  const fov = scene.peek().camera?.["fov"];
  return typeof fov === "number" ? fov : 42;
}

/** All in sight, from where the camera is. */
export function frameAll(): void {
  const v = view.peek();
  const pose = currentPose();
  if (v && pose) {
    writePose(framed(pose, v.lower, v.upper, fovOf(), v.width / v.height), "");
  }
}
