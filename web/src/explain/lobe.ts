// The specular lobe in the plane of incidence: how strong the highlight of one light is for an eye in each direction around the surface's point.
// The formulas are those of src/shade/lighting.hpp (specular_factor, reflect_ggx).
import type { Vec3 } from "../engine/types";
import { lobeNormalization, luminance, microfacetsAt } from "./equation";

export interface LobeSurface {
  /** `phong`, `blinn-phong` or `ggx` */
  lighting: string;
  n: number;
  k_s: Vec3;
  normal: Vec3;
  toLight: Vec3;
  /** weighted by N.L, and scaled so that k_s is reflected; nothing changes for `ggx` */
  normalized: boolean;
}

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (a: Vec3, x: number, b: Vec3, y: number): Vec3 => [a[0] * x + b[0] * y, a[1] * x + b[1] * y, a[2] * x + b[2] * y];
const unit = (a: Vec3): Vec3 => {
  const size = Math.hypot(...a);
  return [a[0] / size, a[1] / size, a[2] / size];
};

/** spec for an eye in a direction; of `ggx` F D Vis N.L, F by its luminance. */
export function lobeValue(s: LobeSurface, toEye: Vec3): number {
  const nDotL = dot(s.normal, s.toLight);
  if (nDotL <= 0) {
    return 0;
  }
  if (s.lighting === "ggx") {
    const { fresnel, d, vis } = microfacetsAt(s.n, s.k_s, s.normal, toEye, s.toLight);
    return luminance(fresnel) * d * vis * nDotL;
  }
  const both = along(s.toLight, 1, toEye, 1);
  const size = Math.hypot(...both);
  const cosine =
    s.lighting === "phong" ? dot(along(s.normal, 2 * nDotL, s.toLight, -1), toEye) : size < 1e-15 ? 0 : dot(s.normal, both) / size;
  const power = Math.max(cosine, 0) ** s.n;
  return s.normalized ? power * lobeNormalization(s.lighting, s.n) * nDotL : power;
}

/** The plane of N and L: N is up, L at the left. */
export interface IncidencePlane {
  up: Vec3;
  side: Vec3;
}

export function planeOf(normal: Vec3, toLight: Vec3, toEye: Vec3): IncidencePlane {
  const across = (v: Vec3): Vec3 => along(v, 1, normal, -dot(v, normal));
  const axis: Vec3 = Math.abs(normal[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0];
  const candidates = [along(across(toLight), -1, normal, 0), across(toEye), across(axis)];
  return { up: normal, side: unit(candidates.find((v) => Math.hypot(...v) > 1e-3)!) };
}

/** An angle from N, to the right, radians. */
export const directionAt = (plane: IncidencePlane, angle: number): Vec3 => along(plane.up, Math.cos(angle), plane.side, Math.sin(angle));

export interface PlaneVector {
  angle: number;
  /** what of the unit vector lies in the plane */
  length: number;
  /** degrees out of the plane */
  outside: number;
}

export function inPlane(plane: IncidencePlane, v: Vec3): PlaneVector {
  const x = dot(v, plane.side);
  const y = dot(v, plane.up);
  const length = Math.min(Math.hypot(x, y), 1);
  return { angle: Math.atan2(x, y), length, outside: (Math.acos(length) * 180) / Math.PI };
}

/** The lobe over the upper half of the plane, finely around the mirror direction, where it may be narrow. */
export function lobeCurve(s: LobeSurface, plane: IncidencePlane): { angle: number; value: number }[] {
  const degree = Math.PI / 180;
  const mirror = -inPlane(plane, s.toLight).angle;
  const angles = Array.from({ length: 361 }, (_, i) => (i / 2 - 90) * degree);
  for (let i = -200; i <= 200; i++) {
    angles.push(mirror + Math.sign(i) * (i / 200) ** 2 * 6 * degree);
  }
  return angles
    .filter((angle) => Math.abs(angle) <= Math.PI / 2 + 1e-9)
    .sort((a, b) => a - b)
    .map((angle) => ({ angle, value: lobeValue(s, directionAt(plane, angle)) }));
}
