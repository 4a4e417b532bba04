// Where an object stands and how large it is, read from its matrix (row-major, column vectors) and written back into it.
import type { Vec3 } from "../engine/types";

const kIdentity: readonly number[] = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const kPlace = [3, 7, 11] as const;

export function matrixOf(stated: unknown): readonly number[] {
  return Array.isArray(stated) && stated.length === 16 && stated.every((n) => typeof n === "number") ? (stated as number[]) : kIdentity;
}

/** undefined for the matrix that changes nothing: it need not be stated. */
function stated(matrix: readonly number[]): number[] | undefined {
  return matrix.every((entry, i) => entry === kIdentity[i]) ? undefined : [...matrix];
}

export function placeOf(matrix: readonly number[]): Vec3 {
  return [matrix[3]!, matrix[7]!, matrix[11]!];
}

export function withPlace(matrix: readonly number[], place: readonly number[]): number[] | undefined {
  return stated(matrix.map((entry, i) => (kPlace.includes(i as 3) ? place[kPlace.indexOf(i as 3)]! : entry)));
}

/** The factor by which volumes grow, as a length: the cube root of the determinant's size. */
export function sizeOf(matrix: readonly number[]): number {
  const [a, b, c, , d, e, f, , g, h, i] = matrix as readonly [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  return Math.cbrt(Math.abs(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)));
}

/** Larger or smaller about its own origin; its turn and proportions stay. */
export function withSize(matrix: readonly number[], size: number): number[] | undefined {
  const before = sizeOf(matrix);
  const factor = before > 0 ? size / before : 1;
  const scaled = (entry: number, i: number) => (i < 12 && i % 4 !== 3 ? Number((entry * factor).toPrecision(6)) : entry);
  return stated(matrix.map(scaled));
}
