// How a light fades with the distance and the angle, from its table in the scene file: fall_off(), attenuate() and spot_factor() of
// src/shade/lighting.hpp, with prepare_light()'s preparation (src/scene/prepare.cpp).

export interface Falloff {
  constant: number;
  linear: number;
  quadratic: number;
  /** p of 1/d^p in place of the three others */
  power?: number;
  unclamped: boolean;
  range?: number;
}

export interface Cone {
  /** half angles, degrees */
  cutoff: number;
  beam?: number;
  exponent: number;
  quadratic: boolean;
}

type Table = Record<string, unknown>;

const number = (value: unknown, otherwise: number): number => (typeof value === "number" ? value : otherwise);
const isNumber = (value: unknown): value is number => typeof value === "number";

/** Lights with a size fade as the small ones that stand for them. */
const isArea = (type: unknown): boolean => type === "rectangle" || type === "disk" || type === "sphere";

export const hasFalloff = (light: Table): boolean => light["type"] === "point" || light["type"] === "spot" || isArea(light["type"]);
export const hasCone = (light: Table): boolean => light["type"] === "spot" || light["type"] === "rectangle" || light["type"] === "disk";

export function falloffOf(light: Table): Falloff {
  if (isArea(light["type"])) {
    return { constant: 0, linear: 0, quadratic: 1, unclamped: true };
  }
  const stated = light["attenuation"];
  const table: Table = typeof stated === "object" && stated !== null ? (stated as Table) : {};
  return {
    constant: number(table["constant"], 1),
    linear: number(table["linear"], 0),
    quadratic: number(table["quadratic"], 0),
    ...(isNumber(table["falloff"]) ? { power: table["falloff"] } : {}),
    unclamped: table["unclamped"] === true,
    ...(isNumber(table["range"]) ? { range: table["range"] } : {}),
  };
}

export function coneOf(light: Table): Cone {
  if (isArea(light["type"])) {
    return { cutoff: 90, exponent: 1, quadratic: false };
  }
  return {
    cutoff: number(light["cutoff"], 45),
    ...(isNumber(light["beam"]) ? { beam: light["beam"] } : {}),
    exponent: number(light["exponent"], 0),
    quadratic: light["fade"] === "quadratic",
  };
}

/** f at the distance d. */
export function attenuationAt(f: Falloff, d: number): number {
  const plain = f.power === undefined ? 1 / (f.constant + (f.linear + f.quadratic * d) * d) : d ** -f.power;
  const limited = f.unclamped ? plain : Math.min(plain, 1);
  if (f.range === undefined) {
    return limited;
  }
  const window = Math.min(Math.max(1 - (d / f.range) ** 4, 0), 1);
  return window === 0 ? 0 : limited * window;
}

/** s where the way from the light to the point leaves the axis by an angle, degrees. */
export function spotAt(c: Cone, degrees: number): number {
  const cosine = (angle: number) => Math.cos((angle * Math.PI) / 180);
  const cs = cosine(degrees);
  const edge = cosine(c.cutoff);
  if (cs < edge - 1e-12) {
    return 0;
  }
  const power = Math.max(cs, 0) ** c.exponent;
  if (c.beam === undefined) {
    return power;
  }
  const width = Math.max(cosine(c.beam) - edge, c.quadratic ? 0.001 : 0);
  const t = width === 0 ? 1 : Math.min(Math.max((cs - edge) / width, 0), 1);
  return power * t * t * (c.quadratic ? 1 : 3 - 2 * t);
}

/** How far a curve of f is worth drawing: to its end, or to where a twentieth is left; at least to `least`. */
export function reachOf(f: Falloff, least = 0): number {
  if (f.range !== undefined) {
    return Math.max(f.range * 1.1, least);
  }
  let reach = Math.max(least, 1);
  for (let i = 0; i < 24 && attenuationAt(f, reach) > 0.05; i++) {
    const next = reach * 1.3;
    if (attenuationAt(f, next) >= attenuationAt(f, reach)) {
      break; // it does not fade
    }
    reach = next;
  }
  return Math.min(reach, Math.max(least * 4, 1e6));
}
