// Where a point of the world is on the stage, and which ray a place of the stage sees: by the view of the latest picture (engine/types.ts,
// ViewInfo). Image coordinates are pixels of a picture, x to the right, y down, (0, 0) the upper left corner of the upper left pixel.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import type { Vec3, ViewInfo } from "../engine/types";
import { fullSize, view } from "../state/picture";
import { add, dot, scaled, subtract, unit } from "./vector";

/** The picture on the page: a rectangle inside of the stage, CSS pixels from the stage's upper left corner. */
export interface StageRect {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Set by stage.tsx. */
export const pictureRect = signal<StageRect>({ left: 0, top: 0, width: 0, height: 0 });

export interface PlacedPoint {
  x: number;
  y: number;
  /** along the view direction, world units */
  depth: number;
}

/** Pixels of the view's picture; undefined where a perspective camera has the point behind it. */
export function worldToPixel(v: ViewInfo, point: Vec3): PlacedPoint | undefined {
  const away = subtract(point, v.eye);
  const depth = dot(away, v.forward);
  if (v.projection === "perspective" && depth <= 0) {
    return undefined;
  }
  const scale = v.projection === "perspective" ? v.pixelsPerUnit / depth : v.pixelsPerUnit;
  return { x: v.width / 2 + dot(away, v.right) * scale, y: v.height / 2 - dot(away, v.up) * scale, depth };
}

/** The world's point that a place of the view's picture shows at a depth. */
export function pixelToWorld(v: ViewInfo, x: number, y: number, depth: number): Vec3 {
  const scale = (v.projection === "perspective" ? depth : 1) / v.pixelsPerUnit;
  const across = add(scaled(v.right, (x - v.width / 2) * scale), scaled(v.up, (v.height / 2 - y) * scale));
  return add(v.eye, add(across, scaled(v.forward, depth)));
}

/** From where, and in which direction (unit), a place of the view's picture looks. */
export function pixelRay(v: ViewInfo, x: number, y: number): { origin: Vec3; direction: Vec3 } {
  if (v.projection === "orthographic") {
    return { origin: pixelToWorld(v, x, y, 0), direction: v.forward };
  }
  return { origin: v.eye, direction: unit(subtract(pixelToWorld(v, x, y, 1), v.eye)) };
}

/** World -> CSS pixels of the overlay (0, 0 is the picture's upper left corner); changes with every picture. */
export const project: ReadonlySignal<(point: Vec3) => PlacedPoint | undefined> = computed(() => {
  const v = view.value;
  const { width, height } = pictureRect.value;
  return (point: Vec3) => {
    const at = v && worldToPixel(v, point);
    return at && { x: (at.x * width) / v.width, y: (at.y * height) / v.height, depth: at.depth };
  };
});

/** CSS pixels of the overlay, at a depth -> world. */
export function unproject(x: number, y: number, depth: number): Vec3 | undefined {
  const v = view.peek();
  const { width, height } = pictureRect.peek();
  return v && width > 0 ? pixelToWorld(v, (x * v.width) / width, (y * v.height) / height, depth) : undefined;
}

/** The world's length that a CSS pixel spans at a depth. */
export function unitsPerCssPixel(v: ViewInfo, depth: number): number {
  const { width } = pictureRect.peek();
  return ((v.projection === "perspective" ? depth : 1) / v.pixelsPerUnit) * (width > 0 ? v.width / width : 1);
}

/** The middle of a pixel of the full picture, in CSS pixels of the overlay. */
export const pixelToStage: ReadonlySignal<(x: number, y: number) => { x: number; y: number }> = computed(() => {
  const { width, height } = pictureRect.value;
  const full = fullSize.value;
  return (x: number, y: number) => ({ x: ((x + 0.5) * width) / (full.width || 1), y: ((y + 0.5) * height) / (full.height || 1) });
});
