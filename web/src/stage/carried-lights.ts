// Lights that are fixed to the camera: when it moves, their stated positions and directions move with it.
import type { SceneDoc, Vec3 } from "../engine/types";
import type { Path } from "../state/path";
import { add, cross, dot, rounded, scaled, subtract, unit } from "./vector";

/** A camera's place and axes, unit and at right angles. */
export interface Frame {
  origin: Vec3;
  axes: readonly [Vec3, Vec3, Vec3];
}

export function frameOf(pose: { eye: Vec3; target: Vec3; up: Vec3 }): Frame {
  const forward = unit(subtract(pose.target, pose.eye));
  const right = unit(cross(forward, pose.up));
  return { origin: pose.eye, axes: [right, cross(right, forward), forward] };
}

/** A direction that stays the same as the camera sees it. */
export function carriedDirection(direction: Vec3, from: Frame, to: Frame): Vec3 {
  return from.axes.reduce<Vec3>((sum, axis, i) => add(sum, scaled(to.axes[i]!, dot(direction, axis))), [0, 0, 0]);
}

export function carriedPoint(point: Vec3, from: Frame, to: Frame): Vec3 {
  return add(to.origin, carriedDirection(subtract(point, from.origin), from, to));
}

const isVector = (value: unknown): value is Vec3 => Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === "number");

/** What changes in the scene when the camera goes from one frame to another. */
export function carriedLights(scene: SceneDoc, attached: readonly number[], from: Frame, to: Frame): [Path, unknown][] {
  const changes: [Path, unknown][] = [];
  for (const index of attached) {
    const light = scene.lights?.[index];
    if (!light) {
      continue;
    }
    const { type = "directional", position, direction, x_axis: edge } = light;
    if (type !== "directional") {
      changes.push([["lights", index, "position"], rounded(carriedPoint(isVector(position) ? position : [0, 0, 0], from, to))]);
    }
    if (type !== "point" && type !== "sphere") {
      changes.push([["lights", index, "direction"], rounded(carriedDirection(isVector(direction) ? direction : [0, 0, -1], from, to))]);
    }
    if (isVector(edge)) {
      changes.push([["lights", index, "x_axis"], rounded(carriedDirection(edge, from, to))]);
    }
  }
  return changes;
}
