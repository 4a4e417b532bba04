// The profile reads the pixels that the line crosses, and says how far two pictures differ.
import { describe, expect, it } from "vitest";
import { differenceOf, placesAlong, stripOf, valuesAt } from "../../src/explain/profile";
import { srgbEncoded } from "../../src/explain/equation";

const kWidth = 8;
const kHeight = 4;
/** red: the column, green: the row, blue: 1 */
const floats = new Float32Array(kWidth * kHeight * 4);
for (let y = 0; y < kHeight; y++) {
  for (let x = 0; x < kWidth; x++) {
    floats.set([x / 8, y / 4, 1, 1], (y * kWidth + x) * 4);
  }
}

describe("places along a line", () => {
  it("are the pixels of a row, each once, from its start to its end", () => {
    const places = placesAlong({ from: { x: 0.5 / 8, y: 0.4 }, to: { x: 7.5 / 8, y: 0.4 } }, kWidth, kHeight);
    expect(places.map(({ x }) => x)).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    expect(places.every(({ y }) => y === 1)).toBe(true);
    expect(places.map(({ distance }) => distance)).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
  });
  it("miss no step of the longer side, and measure the line itself", () => {
    const places = placesAlong({ from: { x: 1, y: 1 }, to: { x: 0, y: 0 } }, kWidth, kHeight);
    expect(places[0]).toMatchObject({ x: 7, y: 3, distance: 0 });
    expect(places.at(-1)).toMatchObject({ x: 0, y: 0 });
    expect(places.at(-1)!.distance).toBeCloseTo(Math.hypot(8, 4), 12);
    places.slice(1).forEach(({ x, y }, i) => {
      expect(Math.abs(x - places[i]!.x)).toBeLessThanOrEqual(1);
      expect(Math.abs(y - places[i]!.y)).toBeLessThanOrEqual(1);
    });
  });
  it("of a line without a length are its pixel", () => {
    const places = placesAlong({ from: { x: 0.5, y: 0.5 }, to: { x: 0.5, y: 0.5 } }, kWidth, kHeight);
    expect(places.every(({ x, y, distance }) => x === 4 && y === 2 && distance === 0)).toBe(true);
  });
});

describe("values", () => {
  const places = placesAlong({ from: { x: 0.5 / 8, y: 0.9 }, to: { x: 7.5 / 8, y: 0.9 } }, kWidth, kHeight);
  it("are those of the pixels, linear", () => {
    const { channels, luminance } = valuesAt(floats, kWidth, places, false);
    expect(channels[0]).toEqual([0, 1, 2, 3, 4, 5, 6, 7].map((x) => x / 8));
    expect(channels[1]).toEqual(Array(8).fill(0.75));
    expect(luminance[4]).toBeCloseTo(0.2126 * 0.5 + 0.7152 * 0.75 + 0.0722, 12);
  });
  it("or as they are stored", () => {
    const { channels, luminance } = valuesAt(floats, kWidth, places, true);
    expect(channels[0][4]).toBeCloseTo(0.7353569830524495, 6);
    expect(luminance[0]).toBeCloseTo(srgbEncoded(0.7152 * 0.75 + 0.0722), 12);
  });
});

it("a difference has its curve, its largest value and its mean square", () => {
  const { values, largest, rms } = differenceOf([1, 2, 0], [0, 2, 2]);
  expect(values).toEqual([1, 0, -2]);
  expect(largest).toBe(2);
  expect(rms).toBeCloseTo(Math.sqrt(5 / 3), 12);
});

it("the strip has the bytes of the pixels", () => {
  const bytes = new Uint8ClampedArray(kWidth * kHeight * 4).map((_, i) => i);
  const places = placesAlong({ from: { x: 0.2, y: 0 }, to: { x: 0.2, y: 1 } }, kWidth, kHeight);
  const strip = stripOf(bytes, kWidth, places);
  places.forEach(({ x, y }, i) =>
    expect([...strip.subarray(i * 4, i * 4 + 4)]).toEqual([...bytes.subarray((y * 8 + x) * 4, (y * 8 + x) * 4 + 4)]),
  );
});
