// The lighting equation of src/shade/lighting.hpp as products of factors: what the engine says of a pixel (Explanation), arranged so that a reader
// can multiply and add it up. All formulas here are the library's; tests hold them against what the engine answers.
import type { Explanation, FragmentExplanation, LightExplanation, ShadingExplanation, Vec3 } from "../engine/types";

export type TermName = "ambient" | "diffuse" | "specular" | "emission" | "fog" | "background";
export const kTerms: readonly TermName[] = ["ambient", "diffuse", "specular", "emission", "fog", "background"];
export type LitTerm = "ambient" | "diffuse" | "specular" | "emission";
export const kLitTerms: readonly LitTerm[] = ["ambient", "diffuse", "specular", "emission"];

export type Channel = 0 | 1 | 2;

/** One factor of a product: a number, or one for each channel. */
export interface Factor {
  tex: string;
  text: string;
  value: number | Vec3;
}

export interface Product {
  factors: Factor[];
  /** what the engine has for it */
  value: Vec3;
}

export const inChannel = (value: number | Vec3, channel: Channel): number => (typeof value === "number" ? value : value[channel]);

export function product(factors: readonly Factor[]): Vec3 {
  const along = (channel: Channel) => factors.reduce((value, factor) => value * inChannel(factor.value, channel), 1);
  return [along(0), along(1), along(2)];
}

export const luminance = (rgb: readonly number[]): number => 0.2126 * rgb[0]! + 0.7152 * rgb[1]! + 0.0722 * rgb[2]!;
export const isZero = (value: Vec3): boolean => value.every((channel) => channel === 0);
export const isOne = (value: Vec3): boolean => value.every((channel) => channel === 1);
const sum = (values: readonly Vec3[]): Vec3 =>
  values.reduce<Vec3>((total, value) => [total[0] + value[0], total[1] + value[1], total[2] + value[2]], [0, 0, 0]);
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Which factors this scene has at all: the others are 1 everywhere and are left out. */
export interface Presence {
  shadows: boolean;
  occlusion: boolean;
}

export function presenceIn(e: Explanation): Presence {
  const shadings = e.fragments.flatMap((fragment) => fragment.shadings);
  return {
    shadows: shadings.some((shading) => shading.lights.some((light) => light.visibility !== 1)),
    occlusion: shadings.some((shading) => shading.openness !== 1),
  };
}

export const hasHighlight = (f: FragmentExplanation): boolean =>
  f.lighting === "phong" || f.lighting === "blinn-phong" || f.lighting === "ggx";

/** What makes the lobe reflect exactly k_s of a uniform light at normal incidence: lobe_normalization(). */
export function lobeNormalization(lighting: string, n: number): number {
  return lighting === "phong" ? (n + 2) / 2 : ((n + 2) * (n + 4)) / (8 * (2 ** (-n / 2) + n));
}

export interface Highlight {
  /** R.V or N.H */
  cosine: number;
  n: number;
  /** the cosine, not below 0, to the power of n; 0 where the light is behind the surface */
  power: number;
  /** of a normalised lobe its factor and N.L; else 1 */
  scale: number;
  value: number;
}

/** spec of `phong` and `blinn-phong`. */
export function highlightOf(e: Explanation, f: FragmentExplanation, s: ShadingExplanation, l: LightExplanation): Highlight {
  const cosine = f.lighting === "phong" ? l.r_dot_v : l.n_dot_h;
  const n = s.shininess;
  const power = l.n_dot_l > 0 ? Math.max(cosine, 0) ** n : 0;
  const scale = e.normalized ? lobeNormalization(f.lighting, n) * Math.max(l.n_dot_l, 0) : 1;
  return { cosine, n, power, scale, value: power * scale };
}

export interface Microfacets {
  alpha2: number;
  vDotH: number;
  nDotV: number;
  fresnel: Vec3;
  d: number;
  vis: number;
}

/** F, D and Vis of `ggx`: microfacets() in src/shade/lighting.hpp. */
export function microfacetsAt(n: number, k_s: Vec3, normal: Vec3, to_eye: Vec3, to_light: Vec3): Microfacets {
  const a = 2 / (n + 2);
  const both = sum([to_light, to_eye]);
  const square = Math.max(dot(both, both), 1e-12);
  const vDotH = Math.abs(dot(to_eye, both)) / Math.sqrt(square);
  const grazing = Math.max(1 - vDotH, 0) ** 5;
  const along = dot(normal, both);
  const across: Vec3 = [
    normal[1] * both[2] - normal[2] * both[1],
    normal[2] * both[0] - normal[0] * both[2],
    normal[0] * both[1] - normal[1] * both[0],
  ];
  const spread = Math.max((a * along * along + dot(across, across)) / square, a);
  const nDotL = dot(normal, to_light);
  const nDotV = Math.abs(dot(normal, to_eye));
  const masking = (cosine: number) => cosine + Math.sqrt(a + (1 - a) * cosine * cosine);
  return {
    alpha2: a,
    vDotH,
    nDotV,
    fresnel: k_s.map((k) => Math.min(k, 1) + (1 - Math.min(k, 1)) * grazing) as Vec3,
    d: a / (spread * spread),
    vis: nDotL > 0 ? 1 / (masking(nDotL) * masking(nDotV)) : 0,
  };
}

export const microfacetsOf = (s: ShadingExplanation, l: LightExplanation): Microfacets =>
  microfacetsAt(s.shininess, s.k_specular, s.normal, s.to_eye, l.to_light);

const kOpenness = (s: ShadingExplanation): Factor => ({ tex: "a", text: "a", value: s.openness });

/** k_a I_a of the scene; of `constant` nothing. */
export function sceneAmbient(e: Explanation, s: ShadingExplanation, has: Presence): Product {
  return {
    factors: [
      ...(has.occlusion ? [kOpenness(s)] : []),
      { tex: "k_a", text: "k_a", value: s.k_ambient },
      { tex: "I_a", text: "I_a", value: e.ambient_light },
    ],
    value: s.scene_ambient,
  };
}

export function sceneEnvironment(s: ShadingExplanation, has: Presence): Product {
  return {
    factors: [
      ...(has.occlusion ? [kOpenness(s)] : []),
      { tex: "k_d", text: "k_d", value: s.k_diffuse },
      { tex: "E", text: "E", value: s.from_environment },
    ],
    value: s.environment,
  };
}

export interface LightProducts {
  ambient: Product;
  diffuse: Product;
  /** absent where the model has none */
  specular?: Product;
}

/** One light's part of the sum. */
export function lightProducts(
  e: Explanation,
  f: FragmentExplanation,
  s: ShadingExplanation,
  l: LightExplanation,
  has: Presence,
): LightProducts {
  const strength: Factor[] = [];
  if (l.distance > 0) {
    strength.push({ tex: "f", text: "f", value: l.attenuation });
  }
  if (l.spot !== 1) {
    strength.push({ tex: "s", text: "s", value: l.spot });
  }
  const direct: Factor[] = has.shadows ? [...strength, { tex: "v", text: "v", value: l.visibility }] : strength;
  const lambert: Factor = { tex: "\\langle N{\\cdot}L\\rangle", text: "max(N·L, 0)", value: Math.max(l.n_dot_l, 0) };
  const ambient: Product = {
    factors: [
      ...strength,
      ...(has.occlusion ? [kOpenness(s)] : []),
      { tex: "k_a", text: "k_a", value: s.k_ambient },
      { tex: "l_a", text: "l_a", value: l.light_ambient },
    ],
    value: l.ambient,
  };
  const k_d: Factor = { tex: "k_d", text: "k_d", value: s.k_diffuse };
  const l_d: Factor = { tex: "l_d", text: "l_d", value: l.light_diffuse };
  const l_s: Factor = { tex: "l_s", text: "l_s", value: l.light_specular };
  if (f.lighting === "ggx") {
    const facets = microfacetsOf(s, l);
    const rest: Vec3 = facets.fresnel.map((value) => 1 - value) as Vec3;
    return {
      ambient,
      diffuse: { factors: [...direct, k_d, l_d, { tex: "(1-F)", text: "(1 − F)", value: rest }, lambert], value: l.diffuse },
      specular: {
        factors: [
          ...direct,
          l_s,
          { tex: "F", text: "F", value: facets.fresnel },
          { tex: "D", text: "D", value: facets.d },
          { tex: "\\mathit{Vis}", text: "Vis", value: facets.vis },
          lambert,
        ],
        value: l.specular,
      },
    };
  }
  const diffuse: Product = { factors: [...direct, k_d, l_d, lambert], value: l.diffuse };
  if (!hasHighlight(f)) {
    return { ambient, diffuse };
  }
  const spec: Factor = { tex: "\\mathrm{spec}", text: "spec", value: highlightOf(e, f, s, l).value };
  return {
    ambient,
    diffuse,
    specular: { factors: [...direct, { tex: "k_s", text: "k_s", value: s.k_specular }, l_s, spec], value: l.specular },
  };
}

/** A term of one evaluation, part by part, before Gouraud's clamp. */
export function shadingParts(s: ShadingExplanation, term: LitTerm): Vec3[] {
  switch (term) {
    case "ambient":
      return [s.scene_ambient, ...s.lights.map((light) => light.ambient)];
    case "diffuse":
      return [s.environment, ...s.lights.map((light) => light.diffuse)];
    case "specular":
      return s.lights.map((light) => light.specular);
    case "emission":
      return [s.k_emission];
  }
}

/** A term of one evaluation, added up and clamped; of `constant` k_d. It is s[term]. */
export function shadingTerm(f: FragmentExplanation, s: ShadingExplanation, term: LitTerm): Vec3 {
  if (f.lighting === "constant") {
    return product([
      { tex: "", text: "", value: term === "diffuse" ? s.k_diffuse : 0 },
      { tex: "", text: "", value: s.clamp },
    ]);
  }
  const total = sum(shadingParts(s, term));
  return [total[0] * s.clamp[0], total[1] * s.clamp[1], total[2] * s.clamp[2]];
}

export const mapsOf = (f: FragmentExplanation, term: LitTerm): Vec3 => f[`maps_${term}`];

/** A term of a fragment from its evaluations: weights, maps, reflection, fog. It is f[term]. */
export function fragmentTerm(f: FragmentExplanation, term: LitTerm): Vec3 {
  const shaded = sum(f.shadings.map((s) => s[term].map((value) => value * s.weight) as Vec3));
  const maps = mapsOf(f, term);
  const reflection = term === "specular" ? f.reflection : [0, 0, 0];
  return shaded.map((value, i) => (value * maps[i]! + reflection[i]!) * f.fog_factor) as Vec3;
}

/** A term of the pixel from its fragments. It is e[term]. */
export function pixelTerm(e: Explanation, term: TermName): Vec3 {
  return term === "background" ? e.background : sum(e.fragments.map((f) => f[term].map((value) => value * f.weight) as Vec3));
}

export const pixelColor = (e: Explanation): Vec3 => sum(kTerms.map((term) => e[term]));

/** The light that brings most to an evaluation: shown first. */
export function strongestLight(s: ShadingExplanation): number {
  let best = 0;
  s.lights.forEach((light, i) => {
    const amount = (of: LightExplanation) => luminance(sum([of.ambient, of.diffuse, of.specular]));
    if (amount(light) > amount(s.lights[best]!)) {
      best = i;
    }
  });
  return best;
}

/** The evaluation that counts most: of `gouraud` the vertex of the largest weight. */
export function heaviestShading(f: FragmentExplanation): number {
  return f.shadings.reduce((best, s, i) => (s.weight > f.shadings[best]!.weight ? i : best), 0);
}

/** What is stored for a linear value where nothing tones it (src/image/srgb.hpp). */
export function srgbEncoded(linear: number): number {
  const c = Math.min(Math.max(linear, 0), 1);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;
}
