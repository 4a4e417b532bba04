// Colours as scene files state them: [r, g, b] is light itself (linear); "#rrggbb", "#rgb" and "color(srgb r g b / a)" are sRGB, unless the
// picture's transfer is `none`: then every number counts as it stands. The curves are those of IEC 61966-2-1.

export type Rgb = [number, number, number];

export interface StatedColor {
  /** as light */
  linear: Rgb;
  alpha?: number;
  /** it was stated as text */
  isText: boolean;
}

export const decoded = (value: number): number => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
export const encoded = (value: number): number => (value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055);

const map = (rgb: Rgb, f: (value: number) => number): Rgb => [f(rgb[0]), f(rgb[1]), f(rgb[2])];

function hexNumbers(text: string): number[] | undefined {
  const digits = /^#([0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})$/i.exec(text)?.[1];
  if (digits === undefined) {
    return undefined;
  }
  const wide = digits.length <= 4 ? [...digits].map((digit) => digit + digit).join("") : digits;
  return (wide.match(/../g) ?? []).map((pair) => parseInt(pair, 16) / 255);
}

function functionNumbers(text: string): number[] | undefined {
  const inner = /^color\(\s*srgb\s+([^)]*)\)$/i.exec(text)?.[1];
  const numbers = inner
    ?.split(/[\s/]+/)
    .filter((part) => part !== "")
    .map(Number);
  return numbers && (numbers.length === 3 || numbers.length === 4) && numbers.every((n) => Number.isFinite(n) && n >= 0)
    ? numbers
    : undefined;
}

/** What a scene states; undefined where that is no colour. isSrgb: the picture's transfer is `srgb`. */
export function readColor(value: unknown, isSrgb: boolean): StatedColor | undefined {
  if (typeof value === "string") {
    const numbers = hexNumbers(value.trim()) ?? functionNumbers(value.trim());
    if (!numbers) {
      return undefined;
    }
    const rgb = numbers.slice(0, 3) as Rgb;
    return { linear: isSrgb ? map(rgb, decoded) : rgb, isText: true, ...(numbers.length === 4 ? { alpha: numbers[3]! } : {}) };
  }
  if (Array.isArray(value) && (value.length === 3 || value.length === 4) && value.every((n) => typeof n === "number")) {
    return { linear: value.slice(0, 3) as Rgb, isText: false, ...(value.length === 4 ? { alpha: value[3] as number } : {}) };
  }
  return undefined;
}

const short = (value: number): number => Number(value.toPrecision(4));

/** As a list of numbers: light itself. */
export function writeLinear(linear: Rgb, alpha?: number): number[] {
  return alpha === undefined ? map(linear, short) : [...map(linear, short), short(alpha)];
}

/** As text: "#rrggbb" where bytes say it exactly, else color(srgb ...). */
export function writeText(linear: Rgb, isSrgb: boolean, alpha?: number): string {
  const rgb = isSrgb ? map(linear, encoded) : linear;
  const all = alpha === undefined ? rgb : [...rgb, alpha];
  const bytes = all.map((value) => Math.round(value * 255));
  if (all.every((value, i) => Math.abs(value * 255 - bytes[i]!) < 1e-3)) {
    return `#${bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
  }
  const numbers = map(rgb, (value) => Number(value.toPrecision(6))).join(" ");
  return alpha === undefined ? `color(srgb ${numbers})` : `color(srgb ${numbers} / ${short(alpha)})`;
}

/** What a screen shows for it, "#rrggbb"; what is brighter than 1 is shown at 1, its hue kept. */
export function screenColor(linear: Rgb, isSrgb: boolean): string {
  const most = Math.max(1, ...linear);
  const rgb = map(linear, (value) => value / most);
  const bytes = (isSrgb ? map(rgb, encoded) : rgb).map((value) => Math.round(255 * Math.min(1, Math.max(0, value))));
  return `#${bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}

/** The colour that a picker gave, as bright as the one before it was where that was brighter than 1. */
export function picked(hex: string, before: Rgb, isSrgb: boolean): Rgb {
  const linear = readColor(hex, isSrgb)?.linear ?? before;
  const most = Math.max(1, ...before);
  return map(linear, (value) => value * most);
}
