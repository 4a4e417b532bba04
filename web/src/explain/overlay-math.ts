// Where arrows, rays and labels of the overlay stand on the picture: world vectors projected, as long as is good to look at.
import type { Vec3 } from "../engine/types";

export interface Point {
  x: number;
  y: number;
}
export type Project = (point: Vec3) => (Point & { depth: number }) | undefined;

export interface Arrow {
  from: Point;
  to: Point;
  label: Point;
  /** it points at the reader, or away: a ring says so, an arrow would be a dot */
  isEndOn: boolean;
}

const kEndOnPixels = 7;
const kLabelPixels = 13;
/** beside the mark of the pixel */
const kEndOnLabelPixels = 24;

/** A unit vector of the world at a point, `length` world units long. */
export function arrowOf(project: Project, at: Vec3, direction: Vec3, length: number): Arrow | undefined {
  const from = project(at);
  const to = project([at[0] + direction[0] * length, at[1] + direction[1] * length, at[2] + direction[2] * length]);
  if (!from || !to) {
    return undefined;
  }
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const size = Math.hypot(dx, dy);
  const isEndOn = size < kEndOnPixels;
  const [ux, uy] = isEndOn ? [0.7, -0.7] : [dx / size, dy / size];
  const reach = isEndOn ? kEndOnLabelPixels : size + kLabelPixels;
  return { from, to, isEndOn, label: { x: from.x + ux * reach, y: from.y + uy * reach } };
}

/** The world's length that makes arrows a fitting share of the picture at a point. */
export function arrowLength(project: Project, at: Vec3, right: Vec3, pixels: number): number {
  const from = project(at);
  const to = project([at[0] + right[0], at[1] + right[1], at[2] + right[2]]);
  const perUnit = from && to ? Math.hypot(to.x - from.x, to.y - from.y) : 0;
  return perUnit > 0 ? pixels / perUnit : 0;
}

/** Labels that lie on each other are moved apart, downwards. */
export function spreadLabels(labels: readonly Point[], gap = 13): Point[] {
  const placed: Point[] = [];
  for (const label of labels) {
    let y = label.y;
    while (placed.some((other) => Math.abs(other.x - label.x) < gap && Math.abs(other.y - y) < gap)) {
      y += gap;
    }
    placed.push({ x: label.x, y });
  }
  return placed;
}
