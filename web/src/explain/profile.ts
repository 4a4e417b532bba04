// The picture's light along a line: the pixels that it crosses, their values, and how far two pictures differ along it.
import { luminance, srgbEncoded } from "./equation";
import type { Place } from "./state";

export interface Line {
  from: Place;
  to: Place;
}

export interface ProfilePlace {
  /** the pixel */
  x: number;
  y: number;
  /** from the line's start, pixels */
  distance: number;
}

/** The pixels along a line, one for each step along its longer side: each place shows the pixel that it lies in. */
export function placesAlong({ from, to }: Line, width: number, height: number): ProfilePlace[] {
  const x = from.x * width;
  const y = from.y * height;
  const dx = to.x * width - x;
  const dy = to.y * height - y;
  const steps = Math.max(1, Math.ceil(Math.max(Math.abs(dx), Math.abs(dy))));
  const whole = Math.hypot(dx, dy);
  const inside = (at: number, size: number) => Math.min(size - 1, Math.max(0, Math.floor(at)));
  return Array.from({ length: steps + 1 }, (_, i) => ({
    x: inside(x + (dx * i) / steps, width),
    y: inside(y + (dy * i) / steps, height),
    distance: (whole * i) / steps,
  }));
}

export interface Values {
  luminance: number[];
  /** red, green, blue */
  channels: [number[], number[], number[]];
}

/** The pixels' values, linear as the engine has them; `encoded` as they are stored (sRGB), each channel by itself. */
export function valuesAt(floats: Float32Array, width: number, places: readonly ProfilePlace[], encoded: boolean): Values {
  const scale = encoded ? srgbEncoded : (value: number) => value;
  const result: Values = { luminance: [], channels: [[], [], []] };
  for (const { x, y } of places) {
    const at = (y * width + x) * 4;
    const rgb = [floats[at]!, floats[at + 1]!, floats[at + 2]!];
    result.luminance.push(scale(luminance(rgb)));
    result.channels.forEach((channel, i) => channel.push(scale(rgb[i]!)));
  }
  return result;
}

export interface Difference {
  values: number[];
  largest: number;
  rms: number;
}

/** One curve less another. */
export function differenceOf(a: readonly number[], b: readonly number[]): Difference {
  const values = a.map((value, i) => value - b[i]!);
  return {
    values,
    largest: values.reduce((most, value) => Math.max(most, Math.abs(value)), 0),
    rms: Math.sqrt(values.reduce((total, value) => total + value * value, 0) / Math.max(1, values.length)),
  };
}

/** A row of pixels, RGBA, for the strip below the plot. */
export function stripOf(bytes: Uint8ClampedArray, width: number, places: readonly ProfilePlace[]): Uint8ClampedArray<ArrayBuffer> {
  const strip = new Uint8ClampedArray(places.length * 4);
  places.forEach(({ x, y }, i) => {
    const at = (y * width + x) * 4;
    strip.set(bytes.subarray(at, at + 4), i * 4);
  });
  return strip;
}
