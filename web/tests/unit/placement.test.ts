import { expect, test } from "vitest";
import { matrixOf, placeOf, sizeOf, withPlace, withSize } from "../../src/state/placement";

const kTurned = [0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7, 0, 0, 0, 1];

test("what is not stated stands at the origin, as large as its mesh", () => {
  const matrix = matrixOf(undefined);
  expect([placeOf(matrix), sizeOf(matrix)]).toEqual([[0, 0, 0], 1]);
  expect(matrixOf([1, 2, 3])).toEqual(matrix);
});

test("moving keeps the turn, sizing keeps the place", () => {
  expect(sizeOf(kTurned)).toBeCloseTo(2, 12);
  expect(withPlace(kTurned, [1, 2, 3])).toEqual([0, 0, 2, 1, 0, 2, 0, 2, -2, 0, 0, 3, 0, 0, 0, 1]);
  expect(withSize(kTurned, 3)).toEqual([0, 0, 3, 5, 0, 3, 0, 6, -3, 0, 0, 7, 0, 0, 0, 1]);
});

test("a mirrored object stays mirrored", () => {
  const mirrored = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  expect(sizeOf(mirrored)).toBe(1);
  expect(withSize(mirrored, 2)![0]).toBe(-2);
});

test("back where it was there is nothing to state", () => {
  expect(withPlace(withPlace(matrixOf(undefined), [1, 0, 0])!, [0, 0, 0])).toBeUndefined();
  expect(withSize(withSize(matrixOf(undefined), 4)!, 1)).toBeUndefined();
});

test("a flat matrix has no size to change", () => {
  const flat = [0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 1];
  expect(withSize(flat, 5)).toEqual(flat);
});
