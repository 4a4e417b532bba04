// The formulas on the panel are TeX that KaTeX takes, and their rounded numbers multiply to what stands behind the last equals sign.
import katex from "katex";
import { describe, expect, it } from "vitest";
import {
  highlightOf,
  lightProducts,
  microfacetsOf,
  presenceIn,
  sceneAmbient,
  type Channel,
  type Product,
} from "../../src/explain/equation";
import { attenuationTex, equationTex, highlightTex, microfacetsTex, productTex, specTex } from "../../src/explain/formulas";
import { reportText } from "../../src/explain/report";
import { explainWords } from "../../src/explain/words";
import type { LightExplanation } from "../../src/engine/types";
import { language } from "../../src/state/settings";
import { factorTex, numberTex, numberText, percentText } from "../../src/plots/number";
import { explained } from "../fixtures/explanations";

const channels: readonly Channel[] = [0, 1, 2];
const compiles = (tex: string) => expect(() => katex.renderToString(tex, { throwOnError: true, strict: "error" }), tex).not.toThrow();

/** `1.2{\times}10^{-5}` as a number. */
const read = (tex: string) => Number(tex.replace(/[()]/g, "").replace(/\{\\times\}10\^\{(-?\d+)\}/, "e$1"));

function expectProduct(shown: Product, channel: Channel): void {
  const tex = productTex(shown, channel);
  compiles(tex);
  const [, factors, result] = tex.split(" = ") as [string, string, string];
  const value = factors.split(" \\cdot ").reduce((total, factor) => total * read(factor), 1);
  expect(Math.abs(value - read(result)), tex).toBeLessThanOrEqual(1e-6 + 4e-3 * Math.abs(read(result)));
}

describe.each(explained)("$name", ({ scene, explanation: e }) => {
  const has = presenceIn(e);
  it("reads as it is", () => {
    for (const f of e.fragments) {
      compiles(equationTex(f.lighting, { ...has, environment: scene["environment"] !== undefined }));
      compiles(highlightTex(f.lighting, e.normalized));
      for (const s of f.shadings.filter(() => f.lighting !== "constant")) {
        channels.forEach((channel) => expectProduct(sceneAmbient(e, s, has), channel));
        for (const l of s.lights) {
          const { ambient, diffuse, specular } = lightProducts(e, f, s, l, has);
          for (const channel of channels) {
            [ambient, diffuse, ...(specular ? [specular] : [])].forEach((shown) => expectProduct(shown, channel));
            if (f.lighting === "ggx" && l.n_dot_l > 0) {
              microfacetsTex(microfacetsOf(s, l), s.k_specular[channel], l, channel).forEach(compiles);
            }
          }
          compiles(specTex(f.lighting, highlightOf(e, f, s, l), l.n_dot_l));
          if (scene.lights && l.distance > 0) {
            compiles(attenuationTex(scene.lights[l.light]!, l));
          }
        }
      }
    }
  });
  it.each(["en", "it"] as const)("as text in %s it ends with the stored bytes, and names every light", (chosen) => {
    language.value = chosen;
    const text = reportText(explainWords.value, e);
    expect(text.trimEnd().endsWith(e.bytes.slice(0, 3).join("  "))).toBe(true);
    const lights = e.fragments.flatMap((f) => f.shadings.flatMap((s) => s.lights));
    expect(text.split("N·L = ").length - 1).toBe(lights.length);
    expect(text).not.toMatch(/undefined|NaN|\[object/);
  });
});

it("attenuation has the numbers of the light's table", () => {
  const at = (distance: number, attenuation: number) => ({ distance, attenuation }) as LightExplanation;
  expect(attenuationTex({ type: "point", attenuation: { constant: 1, linear: 0.1 } }, at(2, 0.8333))).toBe(
    "f = \\min\\bigl(1, \\frac{1}{1 + 0.1\\cdot 2}\\bigr) = 0.8333",
  );
  expect(attenuationTex({ type: "sphere" }, at(2, 0.25))).toBe("f = \\frac{1}{1\\cdot 2^2} = 0.25");
  expect(attenuationTex({ type: "spot", attenuation: { falloff: 1.5, range: 4, unclamped: true } }, at(2, 0.3315))).toBe(
    "f = \\frac{1}{2^{1.5}} \\cdot \\max\\bigl(0, 1 - (2/4)^4\\bigr) = 0.3315",
  );
});

describe("numbers", () => {
  it.each([
    [0, "0", "0"],
    [0.738829, "0.7388", "0.7388"],
    [-0.5, "−0.5", "-0.5"],
    [0.001, "0.001", "0.001"],
    [0.00012345, "1.234×10⁻⁴", "1.234{\\times}10^{-4}"],
    [12345678, "1.235×10⁷", "1.235{\\times}10^{7}"],
    [1e-12, "1×10⁻¹²", "1{\\times}10^{-12}"],
    [Infinity, "∞", "\\infty"],
  ])("%d is %s", (value, text, tex) => {
    expect(numberText(value)).toBe(text);
    expect(numberTex(value)).toBe(tex);
  });
  it("stand in parentheses as negative factors, and as percent", () => {
    expect(factorTex(-2)).toBe("(-2)");
    expect(percentText(0.2512)).toBe("25.1 %");
  });
});
