// What a control shows of an option: its default as a value, and ranges for sliders where the library's own range is endless.
import type { Option } from "../engine/types";

/** The default as a scene file would state it; undefined where it is no fixed value ("frames the whole scene"). */
export function defaultValue(option: Option): unknown {
  const text = option.default;
  const numbers = text.split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
  const isNumeric = numbers.every((n) => Number.isFinite(n));
  switch (option.kind) {
    case "boolean":
      return text.startsWith("true");
    case "integer":
    case "number":
      return isNumeric && numbers.length === 1 ? numbers[0] : undefined;
    case "triple":
      return isNumeric ? (numbers.length === 1 ? [numbers[0], numbers[0], numbers[0]] : numbers) : undefined;
    case "vector":
    case "color":
    case "color_alpha":
    case "pair":
    case "matrix":
    case "affine":
      return isNumeric ? numbers : undefined;
    case "word":
    case "wrap":
      return option.words.some(({ word }) => word === text) ? text : undefined;
    case "terms":
      return text.split(",");
    case "text":
      return "";
    default:
      return undefined;
  }
}

export interface SliderRange {
  from: number;
  to: number;
  scale: "linear" | "log";
}

/** Where a slider's ends are for what has no ends of its own; `scene`: times the size of what is shown. */
const kSoft: Record<string, { from: number; to: number; scale?: "log"; scene?: true }> = {
  "image.tone.exposure": { from: -6, to: 6 },
  "camera.fov": { from: 5, to: 120 },
  "camera.height": { from: 0.1, to: 4, scene: true, scale: "log" },
  "camera.near": { from: 0.001, to: 3, scene: true, scale: "log" },
  "camera.far": { from: 0.1, to: 10, scene: true, scale: "log" },
  "lights[].exponent": { from: 0, to: 200, scale: "log" },
  "lights[].radius": { from: 0.01, to: 1, scene: true, scale: "log" },
  "lights[].attenuation.constant": { from: 0, to: 4 },
  "lights[].attenuation.linear": { from: 0, to: 2 },
  "lights[].attenuation.quadratic": { from: 0, to: 2 },
  "lights[].attenuation.falloff": { from: 0, to: 4 },
  "lights[].attenuation.range": { from: 0.1, to: 4, scene: true, scale: "log" },
  "fog.density": { from: 0, to: 2 },
  "fog.start": { from: 0, to: 4, scene: true },
  "fog.end": { from: 0, to: 6, scene: true },
  "environment.rotation": { from: -180, to: 180 },
  "shadow.size": { from: 64, to: 8192, scale: "log" },
  "occlusion.directions": { from: 4, to: 1024, scale: "log" },
  "occlusion.size": { from: 16, to: 1024, scale: "log" },
  "occlusion.radius": { from: 0.01, to: 1, scene: true, scale: "log" },
  "ground.height": { from: -2, to: 1, scene: true },
  "materials.*.shininess": { from: 0, to: 1000, scale: "log" },
  "materials.*.refraction": { from: 1, to: 3 },
};

/** The largest own range that a slider can resolve. */
const kWidest = 1000;

/** The slider of an option; undefined: a number alone. sceneSize: the diagonal of all that is shown. */
export function sliderRange(name: string, option: Option, sceneSize: number): SliderRange | undefined {
  const soft = kSoft[name];
  if (soft) {
    const factor = soft.scene ? niceSize(sceneSize) : 1;
    return { from: soft.from * factor, to: soft.to * factor, scale: soft.scale ?? "linear" };
  }
  const { minimum, maximum } = option;
  if (minimum !== undefined && maximum !== undefined && maximum - minimum <= kWidest) {
    return { from: minimum, to: maximum, scale: "linear" };
  }
  return undefined;
}

/** 1, 2 or 5 times a power of ten: so that sliders keep their ends while a scene grows a little. */
export function niceSize(size: number): number {
  if (!(size > 0) || !Number.isFinite(size)) {
    return 1;
  }
  const power = 10 ** Math.floor(Math.log10(size));
  const digit = size / power;
  return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

/** Below this share of a logarithmic slider that begins at 0 lies 0 itself. */
const kZeroShare = 0.02;

/** 0..1 along the slider. */
export function toShare({ from, to, scale }: SliderRange, value: number): number {
  if (scale === "linear") {
    return Math.min(1, Math.max(0, (value - from) / (to - from)));
  }
  const low = from > 0 ? from : to / 1e4;
  if (value <= low) {
    return value <= 0 || from > 0 ? 0 : kZeroShare;
  }
  return Math.min(1, Math.log(value / low) / Math.log(to / low));
}

export function fromShare({ from, to, scale }: SliderRange, share: number): number {
  if (scale === "linear") {
    return from + share * (to - from);
  }
  if (from <= 0 && share < kZeroShare) {
    return 0;
  }
  const low = from > 0 ? from : to / 1e4;
  return low * (to / low) ** share;
}

/** Within the option's own range. */
export function isAllowed(option: Option, value: number): boolean {
  if (!Number.isFinite(value) || (option.kind === "integer" && !Number.isInteger(value))) {
    return false;
  }
  if (option.allowed && option.allowed.length > 0) {
    return option.allowed.includes(value);
  }
  const { minimum = -Infinity, maximum = Infinity, minimumOpen = false, maximumOpen = false } = option;
  return (minimumOpen ? value > minimum : value >= minimum) && (maximumOpen ? value < maximum : value <= maximum);
}

/** The range in words: `0..90`, `> 0`. */
export function rangeText(option: Option): string {
  const { minimum, maximum, minimumOpen, maximumOpen, allowed } = option;
  if (allowed && allowed.length > 0) {
    return allowed.join(", ");
  }
  const low = minimum === undefined ? "" : `${minimumOpen ? ">" : "≥"} ${minimum}`;
  const high = maximum === undefined ? "" : `${maximumOpen ? "<" : "≤"} ${maximum}`;
  return [low, high].filter((part) => part !== "").join(", ");
}
