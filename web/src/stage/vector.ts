// Vectors as plain triples: what the camera and the handles need.
import type { Vec3 } from "../engine/types";

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vec3, factor: number): Vec3 => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);

/** Of length 1; a vector without a direction becomes `instead`. */
export function unit(a: Vec3, instead: Vec3 = [0, 0, 1]): Vec3 {
  const size = length(a);
  return size > 0 && Number.isFinite(size) ? scaled(a, 1 / size) : instead;
}

/** Turned about a unit axis, counter-clockwise where the axis points at the reader (Rodrigues). */
export function turned(a: Vec3, axis: Vec3, radians: number): Vec3 {
  const c = Math.cos(radians);
  const s = Math.sin(radians);
  return add(add(scaled(a, c), scaled(cross(axis, a), s)), scaled(axis, dot(axis, a) * (1 - c)));
}

/** Few enough digits to read and to travel in a link, enough for a picture: 5 behind the first of the largest number. */
export function rounded(a: Vec3, magnitude = Math.max(...a.map(Math.abs))): Vec3 {
  const digits = magnitude > 0 && Number.isFinite(magnitude) ? Math.min(12, Math.max(0, 5 - Math.floor(Math.log10(magnitude)))) : 0;
  const factor = 10 ** digits;
  return a.map((value) => Math.round(value * factor) / factor + 0) as Vec3;
}
