// The polar plot's curve is the engine's highlight: at the eye that looked, and where it must have its peak.
import { describe, expect, it } from "vitest";
import type { Vec3 } from "../../src/engine/types";
import { highlightOf, luminance, product, lightProducts, presenceIn } from "../../src/explain/equation";
import { directionAt, inPlane, lobeCurve, lobeValue, planeOf, type LobeSurface } from "../../src/explain/lobe";
import { explained, expectNear } from "../fixtures/explanations";

const lit = explained.flatMap(({ name, explanation: e }) =>
  e.fragments.flatMap((f) =>
    f.shadings.flatMap((s) => s.lights.map((l) => ({ name, e, f, s, l }))).filter(({ f: { lighting } }) => /phong|ggx/.test(lighting)),
  ),
);

it.each(lit)("$name: the lobe at the eye is the highlight of the pixel", ({ e, f, s, l }) => {
  const surface: LobeSurface = {
    lighting: f.lighting,
    n: s.shininess,
    k_s: s.k_specular,
    normal: s.normal,
    toLight: l.to_light,
    normalized: e.normalized,
  };
  const specular = lightProducts(e, f, s, l, presenceIn(e)).specular!;
  const expected =
    f.lighting === "ggx"
      ? l.n_dot_l > 0
        ? luminance(product(specular.factors.slice(specular.factors.findIndex(({ tex }) => tex === "F"))))
        : 0
      : highlightOf(e, f, s, l).value;
  expectNear(lobeValue(surface, s.to_eye), expected);
});

describe.each(["phong", "blinn-phong", "ggx"])("%s", (lighting) => {
  const angle = 0.6;
  const surface: LobeSurface = {
    lighting,
    n: 400,
    k_s: [0.5, 0.5, 0.5],
    normal: [0, 1, 0],
    toLight: [-Math.sin(angle), Math.cos(angle), 0],
    normalized: false,
  };
  const plane = planeOf(surface.normal, surface.toLight, [0, 0, 1]);
  const curve = lobeCurve(surface, plane);
  const peak = curve.reduce((best, point) => (point.value > best.value ? point : best));

  it("has L at the left and its peak in the mirror direction", () => {
    expect(inPlane(plane, surface.toLight).angle).toBeCloseTo(-angle, 9);
    expect(Math.abs(peak.angle - angle)).toBeLessThan(0.02);
    if (lighting !== "ggx") {
      expect(peak.value).toBeCloseTo(1, 9);
    }
  });
  it("is drawn finely where it is narrow", () => {
    const near = curve.filter((point) => Math.abs(point.angle - angle) < 0.02);
    expect(near.length).toBeGreaterThan(30);
    expect(curve.every((point, i) => i === 0 || point.angle >= curve[i - 1]!.angle)).toBe(true);
  });
});

describe("the plane of incidence", () => {
  it("holds N and L, and says how far the eye stands out of it", () => {
    const toEye: Vec3 = [0, Math.SQRT1_2, Math.SQRT1_2];
    const plane = planeOf([0, 1, 0], [-0.6, 0.8, 0], toEye);
    expect(inPlane(plane, [-0.6, 0.8, 0]).outside).toBeCloseTo(0, 4);
    expect(inPlane(plane, toEye).outside).toBeCloseTo(45, 6);
    expect(directionAt(plane, Math.PI / 2)[0]).toBeCloseTo(1, 9);
  });
  it("is that of the eye where the light stands above the point, and any where both do", () => {
    expect(inPlane(planeOf([0, 1, 0], [0, 1, 0], [0, 0.6, 0.8]), [0, 0.6, 0.8]).outside).toBeCloseTo(0, 4);
    expect(Math.hypot(...planeOf([0, 1, 0], [0, 1, 0], [0, 1, 0]).side)).toBeCloseTo(1, 9);
  });
});

it("a normalised lobe is weighted by N.L and its factor", () => {
  const surface: LobeSurface = { lighting: "phong", n: 6, k_s: [1, 1, 1], normal: [0, 0, 1], toLight: [0, 0.6, 0.8], normalized: true };
  expect(lobeValue(surface, [0, -0.6, 0.8])).toBeCloseTo(4 * 0.8, 12);
  expect(lobeValue({ ...surface, toLight: [0, 0.6, -0.8] }, [0, -0.6, 0.8])).toBe(0);
});
