// Where the overlay's arrows stand.
import { describe, expect, it } from "vitest";
import { arrowLength, arrowOf, spreadLabels, type Project } from "../../src/explain/overlay-math";

/** Looks along -z from z = 5, 100 pixels a unit at depth 1. */
const project: Project = ([x, y, z]) => (z < 5 ? { x: 200 + (100 * x) / (5 - z), y: 150 - (100 * y) / (5 - z), depth: 5 - z } : undefined);

describe("an arrow", () => {
  it("begins at the point and ends where its tip is seen, the label beyond it", () => {
    const arrow = arrowOf(project, [0, 0, 0], [1, 0, 0], 2)!;
    expect(arrow.from).toMatchObject({ x: 200, y: 150 });
    expect(arrow.to).toMatchObject({ x: 240, y: 150 });
    expect(arrow.label.x).toBeGreaterThan(240);
    expect(arrow.isEndOn).toBe(false);
  });
  it("at the reader is a ring with a label beside it", () => {
    const arrow = arrowOf(project, [0, 0, 0], [0, 0, 1], 2)!;
    expect(arrow.isEndOn).toBe(true);
    expect(Math.hypot(arrow.label.x - 200, arrow.label.y - 150)).toBeGreaterThan(8);
  });
  it("whose tip is behind the eye is not drawn", () => {
    expect(arrowOf(project, [0, 0, 0], [0, 0, 1], 6)).toBeUndefined();
  });
  it("has the length that was asked for, in pixels, when it lies across the view", () => {
    const length = arrowLength(project, [0, 0, 1], [1, 0, 0], 80);
    const arrow = arrowOf(project, [0, 0, 1], [0, 1, 0], length)!;
    expect(Math.hypot(arrow.to.x - arrow.from.x, arrow.to.y - arrow.from.y)).toBeCloseTo(80, 9);
  });
});

it("labels that lie on each other are moved apart", () => {
  const placed = spreadLabels([
    { x: 10, y: 10 },
    { x: 12, y: 11 },
    { x: 11, y: 12 },
    { x: 200, y: 10 },
  ]);
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < i; j++) {
      expect(Math.abs(placed[i]!.y - placed[j]!.y)).toBeGreaterThanOrEqual(12.9);
    }
  }
  expect(placed[3]).toEqual({ x: 200, y: 10 });
});
