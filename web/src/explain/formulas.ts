// The formulas of docs/theory/lighting-equation.md as TeX, and with an explanation's numbers in place of the letters.
import type { LightExplanation } from "../engine/types";
import { factorTex, numberTex } from "../plots/number";
import { falloffOf } from "../plots/falloff";
import { inChannel, type Channel, type Highlight, type Microfacets, type Presence, type Product } from "./equation";

const dots = (a: string, b: string) => `${a}{\\cdot}${b}`;
export const kNDotL = dots("N", "L");

/** The whole sum of a model, with the factors that this scene has. */
export function equationTex(lighting: string, has: Presence & { environment: boolean }): string {
  if (lighting === "constant") {
    return "I = k_d";
  }
  const a = has.occlusion ? "a\\," : "";
  const v = has.shadows ? "v_i\\," : "";
  const around = `k_e + ${a}k_a I_a${has.environment ? ` + ${a}k_d E` : ""}`;
  const lambert = `\\langle ${dots("N", "L_i")}\\rangle`;
  const ambient = `${a}k_a l_{a,i}`;
  const diffuse = `${v}k_d l_{d,i}${lighting === "ggx" ? "(1{-}F)" : ""}${lambert}`;
  const specular =
    lighting === "lambert"
      ? ""
      : lighting === "ggx"
        ? `{} + ${v}l_{s,i}\\,F D\\,\\mathit{Vis}\\,${lambert}`
        : `{} + ${v}k_s l_{s,i}\\,\\mathrm{spec}_i`;
  return `\\begin{aligned} I = {}& ${around} \\\\ &{}+ \\sum_i f_i s_i \\bigl[\\, ${ambient} + ${diffuse} ${
    specular === "" ? "" : `\\\\ &\\qquad\\qquad ${specular}`
  } \\,\\bigr] \\end{aligned}`;
}

/** What spec, F, D and Vis are. */
export function highlightTex(lighting: string, normalized: boolean): string {
  const gate = "\\text{, 0 where } N{\\cdot}L \\le 0";
  switch (lighting) {
    case "phong":
      return `\\mathrm{spec} = ${normalized ? `\\tfrac{n+2}{2}\\langle ${kNDotL}\\rangle\\,` : ""}\\langle ${dots("R", "V")}\\rangle^n${gate}`;
    case "blinn-phong":
      return `\\mathrm{spec} = ${normalized ? `\\tfrac{(n+2)(n+4)}{8(2^{-n/2}+n)}\\langle ${kNDotL}\\rangle\\,` : ""}\\langle ${dots("N", "H")}\\rangle^n${gate}`;
    case "ggx":
      return [
        "\\begin{aligned} F &= k_s + (1-k_s)(1-|V{\\cdot}H|)^5",
        "D &= \\alpha^2 / \\bigl((N{\\cdot}H)^2(\\alpha^2-1)+1\\bigr)^2",
        "\\mathit{Vis} &= 1 / \\bigl(m(N{\\cdot}L)\\; m(|N{\\cdot}V|)\\bigr)",
        "m(x) &= x + \\sqrt{\\alpha^2 + (1-\\alpha^2)x^2}, \\quad \\alpha^2 = 2/(n+2) \\end{aligned}",
      ].join(" \\\\ ");
    default:
      return "";
  }
}

/** `k_d l_d ⟨N.L⟩ = 0.8 · 1 · 0.5 = 0.4` in one channel; the last number is the engine's. */
export function productTex({ factors, value }: Product, channel: Channel, more = ""): string {
  const letters = factors.map(({ tex }) => tex).join("\\,");
  const numbers = factors.map((factor) => factorTex(inChannel(factor.value, channel))).join(" \\cdot ");
  return `${letters}${more} = ${numbers} = ${numberTex(value[channel])}`;
}

/** spec with numbers. */
export function specTex(lighting: string, h: Highlight, nDotL: number): string {
  const cosine = lighting === "phong" ? dots("R", "V") : dots("N", "H");
  if (nDotL <= 0) {
    return `\\mathrm{spec} = 0 \\text{, as } ${kNDotL} \\le 0`;
  }
  const scale = h.scale === 1 ? "" : `${numberTex(h.scale)} \\cdot `;
  const base = h.cosine < 0 ? "0" : numberTex(h.cosine);
  const letters = `\\mathrm{spec} = ${h.scale === 1 ? "" : "c\\,"}\\langle ${cosine}\\rangle^n`;
  return `${letters} = ${scale}${base}^{${numberTex(h.n)}} = ${numberTex(h.value)}`;
}

/** F, D and Vis with numbers, in one channel. */
export function microfacetsTex(m: Microfacets, k_s: number, l: LightExplanation, channel: Channel): string[] {
  const k = numberTex(Math.min(k_s, 1));
  return [
    `\\alpha^2 = ${numberTex(m.alpha2)}`,
    `F = ${k} + (1-${k})(1-${numberTex(m.vDotH)})^5 = ${numberTex(m.fresnel[channel])}`,
    `D = \\frac{${numberTex(m.alpha2)}}{(${numberTex(l.n_dot_h)}^2(${numberTex(m.alpha2)}-1)+1)^2} = ${numberTex(m.d)}`,
    `\\mathit{Vis} = \\frac{1}{m(${numberTex(l.n_dot_l)})\\; m(${numberTex(m.nDotV)})} = ${numberTex(m.vis)}`,
  ];
}

/** f with the numbers of the light's table. */
export function attenuationTex(table: Record<string, unknown>, light: LightExplanation): string {
  const falloff = falloffOf(table);
  const d = numberTex(light.distance);
  const base =
    falloff.power === undefined
      ? `\\frac{1}{${[
          ...(falloff.constant === 0 ? [] : [numberTex(falloff.constant)]),
          ...(falloff.linear === 0 ? [] : [`${numberTex(falloff.linear)}\\cdot ${d}`]),
          ...(falloff.quadratic === 0 ? [] : [`${numberTex(falloff.quadratic)}\\cdot ${d}^2`]),
        ].join(" + ")}}`
      : `\\frac{1}{${d}^{${numberTex(falloff.power)}}}`;
  const limited = falloff.unclamped ? base : `\\min\\bigl(1, ${base}\\bigr)`;
  const range = falloff.range === undefined ? "" : ` \\cdot \\max\\bigl(0, 1 - (${d}/${numberTex(falloff.range)})^4\\bigr)`;
  return `f = ${limited}${range} = ${numberTex(light.attenuation)}`;
}
