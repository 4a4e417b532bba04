// The falloff curves are the engine's: at the distances and angles of real pixels, and at the clauses of the formulas.
import { describe, expect, it } from "vitest";
import { attenuationAt, coneOf, falloffOf, reachOf, spotAt } from "../../src/plots/falloff";
import { curvePoints, ticks } from "../../src/plots/curve";
import { explained, expectNear } from "../fixtures/explanations";

const withLights = explained.filter(({ scene }) => scene.lights);

describe.each(withLights)("$name", ({ scene, explanation }) => {
  it("f and s are what the engine had", () => {
    for (const { lights } of explanation.fragments.flatMap((f) => f.shadings)) {
      for (const l of lights) {
        const table = scene.lights![l.light]!;
        if (l.distance > 0) {
          expectNear(attenuationAt(falloffOf(table), l.distance), l.attenuation, "f");
        }
        if (table["type"] === "spot") {
          const [x, y, z] = table["direction"] as [number, number, number];
          const cosine = -(x * l.to_light[0] + y * l.to_light[1] + z * l.to_light[2]) / Math.hypot(x, y, z);
          expect(spotAt(coneOf(table), (Math.acos(cosine) * 180) / Math.PI)).toBeCloseTo(l.spot, 4);
        }
      }
    }
  });
});

it("the pixels are at many distances and angles, inside and outside of the cone", () => {
  const lights = withLights.flatMap(({ explanation: e }) => e.fragments.flatMap((f) => f.shadings.flatMap((s) => s.lights)));
  expect(lights.some((l) => l.attenuation > 0 && l.attenuation < 1)).toBe(true);
  expect(lights.some((l) => l.spot === 0)).toBe(true);
  expect(lights.some((l) => l.spot > 0.5 && l.spot < 0.97)).toBe(true);
});

describe("falloff", () => {
  it("is limited to 1, unless it is unclamped", () => {
    expect(attenuationAt(falloffOf({ type: "point", attenuation: { falloff: 2 } }), 0.5)).toBe(1);
    expect(attenuationAt(falloffOf({ type: "point", attenuation: { falloff: 2, unclamped: true } }), 0.5)).toBe(4);
    expect(attenuationAt(falloffOf({ type: "point", attenuation: { falloff: 0 } }), 7)).toBe(1);
  });
  it("ends at its range, after the limit", () => {
    const f = falloffOf({ type: "point", attenuation: { falloff: 2, range: 4 } });
    expect(attenuationAt(f, 0.5)).toBeCloseTo(1 - (0.5 / 4) ** 4, 12);
    expect(attenuationAt(f, 4)).toBe(0);
    expect(attenuationAt(f, 9)).toBe(0);
    expect(reachOf(f)).toBeCloseTo(4.4, 9);
  });
  it("of a light with a size is that of what stands for it", () => {
    expect(attenuationAt(falloffOf({ type: "sphere", radius: 2 }), 0.5)).toBe(4);
    expect(spotAt(coneOf({ type: "disk" }), 60)).toBeCloseTo(0.5, 12);
  });
  it("is drawn at least so far as is asked, and to where little is left", () => {
    expect(reachOf(falloffOf({ type: "point" }), 12)).toBe(12);
    const f = falloffOf({ type: "point", attenuation: { quadratic: 1 } });
    expect(attenuationAt(f, reachOf(f))).toBeLessThan(0.06);
  });
});

describe("a cone", () => {
  it("has its edge, and nothing beyond it", () => {
    const hard = coneOf({ type: "spot", cutoff: 30 });
    expect(spotAt(hard, 30)).toBe(1);
    expect(spotAt(hard, 30.01)).toBe(0);
  });
  it("falls with the exponent, and from the beam on by smoothstep or by the square", () => {
    expect(spotAt(coneOf({ type: "spot", cutoff: 80, exponent: 2 }), 60)).toBeCloseTo(0.25, 12);
    const middle = (Math.acos((Math.cos(Math.PI / 6) + Math.cos(Math.PI / 3)) / 2) * 180) / Math.PI;
    expect(spotAt(coneOf({ type: "spot", cutoff: 60, beam: 30 }), middle)).toBeCloseTo(0.5, 12);
    expect(spotAt(coneOf({ type: "spot", cutoff: 60, beam: 30, fade: "quadratic" }), middle)).toBeCloseTo(0.25, 12);
    expect(spotAt(coneOf({ type: "spot", cutoff: 60, beam: 30 }), 29)).toBe(1);
  });
});

it("a curve is drawn on both sides of its jumps", () => {
  const points = curvePoints((x) => (x <= 3 ? 1 : 0), 10, [3]);
  const jump = points.findIndex(([, y]) => y === 0);
  expect(points[jump]![0] - points[jump - 1]![0]).toBeLessThan(1e-6);
  expect(points.every(([x], i) => i === 0 || x >= points[i - 1]![0])).toBe(true);
});

it("ticks are round and end within the axis", () => {
  expect(ticks(9.9, 4)).toEqual([0, 5]);
  expect(ticks(1, 2)).toEqual([0, 0.5, 1]);
  expect(ticks(45, 4)).toEqual([0, 20, 40]);
  expect(ticks(0, 4)).toEqual([0]);
});
