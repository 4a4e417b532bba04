import { expect, test } from "vitest";
import { kFrameMilliseconds, Pace } from "../../src/stage/pace";

/** Draws pictures of a machine that needs so many nanoseconds a pixel, as the loop does while something is dragged. */
function settle(pace: Pace, nanoseconds: number, pixels: number, fixed = 0): { scale: number; milliseconds: number } {
  let scale = 1;
  let milliseconds = 0;
  for (let i = 0; i < 60; i++) {
    scale = pace.scaleFor(pixels);
    milliseconds = fixed + pixels * scale * scale * nanoseconds * 1e-6;
    pace.learnQuick(pixels * scale * scale, milliseconds);
  }
  return { scale, milliseconds };
}

test("pictures become as small as a frame's time demands, and no smaller", () => {
  const { scale, milliseconds } = settle(new Pace(), 100, 1e6);
  expect(milliseconds).toBeLessThanOrEqual(kFrameMilliseconds);
  expect(scale).toBeGreaterThanOrEqual(0.4);
});

test("a fast machine draws the full size", () => {
  expect(settle(new Pace(), 5, 1e6).scale).toBe(1);
});

test("the slowest one still shows something", () => {
  expect(settle(new Pace(), 1e5, 1e6).scale).toBeGreaterThanOrEqual(0.19);
});

test("what slows down and recovers is followed", () => {
  const pace = new Pace();
  settle(pace, 5, 1e6);
  expect(settle(pace, 400, 1e6).milliseconds).toBeLessThanOrEqual(kFrameMilliseconds);
  expect(settle(pace, 5, 1e6).scale).toBe(1);
});

test("what every picture takes is told from what its pixels take", () => {
  const pace = new Pace();
  settle(pace, 400, 1e6, 0);
  const { scale, milliseconds } = settle(pace, 20, 1e6, 15);
  expect(milliseconds).toBeLessThanOrEqual(kFrameMilliseconds + 1);
  expect(scale).toBeGreaterThanOrEqual(0.5);
});

test("where triangles alone take longer than a frame, pictures stay legible", () => {
  const { scale, milliseconds } = settle(new Pace(), 40, 1e6, 60);
  expect(scale).toBeGreaterThanOrEqual(0.5);
  expect(milliseconds).toBeLessThanOrEqual(95);
});

test("a full picture is expected to take what the one before took, by its size and samples", () => {
  const pace = new Pace();
  expect(pace.expectedFull(1e6, 8)).toBe(0);
  pace.learnFull(1e6, 1, 50);
  expect(pace.expectedFull(2e6, 1)).toBeCloseTo(100, 9);
  expect(pace.expectedFull(1e6, 8)).toBeGreaterThan(150);
});
