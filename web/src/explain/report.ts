// An explanation as plain text, for notes and exercises: the same numbers as in the panel.
import type { Explanation, FragmentExplanation, ShadingExplanation } from "../engine/types";
import { numberText, percentText, vectorText } from "../plots/number";
import { inChannel, isOne, isZero, kTerms, lightProducts, presenceIn, sceneAmbient, sceneEnvironment, type Product } from "./equation";
import { named } from "./rows";
import type { ExplainWords } from "./words";

function productLines(name: string, { factors, value }: Product): string[] {
  const letters = factors.map(({ text }) => text).join(" · ");
  const channels = ([0, 1, 2] as const).map((channel) => {
    const numbers = factors.map((factor) => numberText(inChannel(factor.value, channel))).join(" · ");
    return `        ${"RGB"[channel]}: ${numbers} = ${numberText(value[channel])}`;
  });
  return [`      ${name} = ${letters}`, ...channels];
}

function shadingLines(t: ExplainWords, e: Explanation, f: FragmentExplanation, s: ShadingExplanation, title: string): string[] {
  const has = presenceIn(e);
  if (f.lighting === "constant") {
    return [`  ${title}`, `    ${t.constant}`, `    k_d  ${vectorText(s.k_diffuse)}`];
  }
  return [
    `  ${title}`,
    `    N  ${vectorText(s.normal)}`,
    `    V  ${vectorText(s.to_eye)}`,
    `    n = ${numberText(s.shininess)}`,
    `    ${t.aroundUs}`,
    ...productLines(t.terms.ambient, sceneAmbient(e, s, has)),
    ...(isZero(s.from_environment) ? [] : productLines(t.terms.diffuse, sceneEnvironment(s, has))),
    ...s.lights.flatMap((l) => {
      const parts = lightProducts(e, f, s, l, has);
      return [
        `    ${t.light(named(l.light, l.name))}`,
        `      L  ${vectorText(l.to_light)}`,
        `      N·L = ${numberText(l.n_dot_l)}   R·V = ${numberText(l.r_dot_v)}   N·H = ${numberText(l.n_dot_h)}`,
        `      f = ${numberText(l.attenuation)}   s = ${numberText(l.spot)}   v = ${numberText(l.visibility)}`,
        ...(isZero(l.light_ambient) ? [] : productLines(t.terms.ambient, parts.ambient)),
        ...productLines(t.terms.diffuse, parts.diffuse),
        ...(parts.specular ? productLines(t.terms.specular, parts.specular) : []),
      ];
    }),
    ...(isOne(s.clamp) ? [] : [`    ${t.clamped} ${vectorText(s.clamp)}`]),
  ];
}

export function reportText(t: ExplainWords, e: Explanation): string {
  const titles = (f: FragmentExplanation, i: number) =>
    e.interpolation === "gouraud"
      ? `${t.vertex(i + 1)}, ${t.weight} ${numberText(f.shadings[i]!.weight)}`
      : e.interpolation === "flat"
        ? t.face
        : t.pixelPoint;
  const lines = [`Pixel ${e.x}, ${e.y} · ${t.interpolations[e.interpolation]}`];
  e.fragments.forEach((f, index) => {
    lines.push("", `${t.surface(index + 1, e.fragments.length)}, ${percentText(f.weight)} ${t.ofThePixel}`);
    lines.push(`  ${t.object} ${named(f.object, f.object_name)}, ${t.material} ${f.material_name}, ${f.lighting}`);
    lines.push(`  ${t.triangle} ${f.triangle}, ${t.barycentrics} ${vectorText(f.barycentrics)}`);
    lines.push(`  ${t.position} ${vectorText(f.position)}`);
    f.shadings.forEach((s, i) => lines.push(...shadingLines(t, e, f, s, titles(f, i))));
    if (f.fog_factor !== 1) {
      lines.push(`  ${t.fogFactor} ${numberText(f.fog_factor)}`);
    }
  });
  if (e.background_weight > 0) {
    lines.push("", t.backgroundIs(percentText(e.background_weight)));
  }
  lines.push("", t.sumOfTerms);
  const width = Math.max(...kTerms.map((term) => t.terms[term].length), t.color.length, t.stored.length) + 2;
  kTerms.forEach((term, i) => lines.push(`${i === 0 ? "  " : "+ "}${t.terms[term].padEnd(width)}${vectorText(e[term])}`));
  lines.push(`= ${t.color.padEnd(width)}${vectorText(e.color.slice(0, 3))}   ${t.alpha} ${numberText(e.color[3])}`);
  lines.push(`  ${t.stored.padEnd(width)}${e.bytes.slice(0, 3).join("  ")}`);
  return `${lines.join("\n")}\n`;
}
