// What the panel shows of a pixel multiplies and adds up: the factors to the terms, the terms to the colour, the colour to the bytes.
import { describe, expect, it } from "vitest";
import {
  fragmentTerm,
  highlightOf,
  kLitTerms,
  kTerms,
  lightProducts,
  pixelColor,
  pixelTerm,
  presenceIn,
  product,
  sceneAmbient,
  sceneEnvironment,
  shadingTerm,
  srgbEncoded,
} from "../../src/explain/equation";
import { explained, expectNear } from "../fixtures/explanations";

describe.each(explained)("$name", ({ scene, explanation: e }) => {
  const has = presenceIn(e);

  it("the shown factors multiply to the terms", () => {
    for (const f of e.fragments.filter(({ lighting }) => lighting !== "constant")) {
      for (const s of f.shadings) {
        expectNear(product(sceneAmbient(e, s, has).factors), s.scene_ambient, "scene's ambient");
        expectNear(product(sceneEnvironment(s, has).factors), s.environment, "environment");
        for (const l of s.lights) {
          const parts = lightProducts(e, f, s, l, has);
          expectNear(product(parts.ambient.factors), l.ambient, "ambient");
          expectNear(product(parts.diffuse.factors), l.diffuse, "diffuse");
          expectNear(parts.specular ? product(parts.specular.factors) : [0, 0, 0], l.specular, "specular");
        }
      }
    }
  });

  it("the lights add up to the evaluations, those to the fragments, those to the pixel", () => {
    for (const f of e.fragments) {
      for (const term of kLitTerms) {
        f.shadings.forEach((s) => expectNear(shadingTerm(f, s, term), s[term], `evaluation's ${term}`));
        expectNear(fragmentTerm(f, term), f[term], `fragment's ${term}`);
      }
      expectNear(
        f.shadings.reduce((total, s) => total + s.weight, 0),
        1,
        "weights",
      );
    }
    kTerms.forEach((term) => expectNear(pixelTerm(e, term), e[term], term));
    expectNear(pixelColor(e), e.color.slice(0, 3), "colour");
    expectNear(
      e.fragments.reduce((total, f) => total + f.weight, e.background_weight),
      1,
      "shares of the pixel",
    );
  });

  it("the colour becomes the bytes", () => {
    const encode = scene.image?.["transfer"] === "none" ? (x: number) => Math.min(x, 1) : srgbEncoded;
    expect(e.bytes.slice(0, 3)).toEqual(e.color.slice(0, 3).map((value) => Math.round(255 * encode(value))));
  });
});

describe("the fixtures have what they shall prove", () => {
  const all = explained.flatMap(({ explanation: e }) => e.fragments.flatMap((f) => f.shadings.map((s) => ({ e, f, s }))));
  it("every model, with highlights that are seen", () => {
    for (const lighting of ["phong", "blinn-phong", "ggx"]) {
      expect(all.some(({ f, s }) => f.lighting === lighting && s.specular[0] > 0.01)).toBe(true);
    }
    expect(new Set(all.map(({ f }) => f.lighting)).size).toBe(5);
  });
  it("fog, clamped vertices, shadows, occlusion, an environment, normalised lobes", () => {
    expect(all.some(({ f }) => f.fog_factor < 1)).toBe(true);
    expect(all.some(({ s }) => s.clamp[0] < 1)).toBe(true);
    expect(all.some(({ s }) => s.lights.some((l) => l.visibility > 0 && l.visibility < 1))).toBe(true);
    expect(all.some(({ s }) => s.openness < 1)).toBe(true);
    expect(all.some(({ s }) => s.environment[0] > 0)).toBe(true);
    expect(all.some(({ e, f, s }) => e.normalized && s.lights.some((l) => highlightOf(e, f, s, l).scale > 1))).toBe(true);
  });
});
