// What is seen besides the scene: which pictures are compared and how, the pixel and the object that are chosen, what Explain shows of them. A
// link restores it, too.
import { batch, effect } from "@preact/signals";
import { movedPixel } from "../explain/ask";
import type { Channel } from "../explain/equation";
import {
  chosenChannel,
  chosenLight,
  drawn,
  isProfileComparing,
  isProfileEncoded,
  kDrawn,
  profileCursor,
  profileLine,
  type DrawnName,
  type Place,
} from "../explain/state";
import { splitLayout } from "../gpu/split";
import { comparison, wipe, type Changes, type Comparison } from "../state/compare";
import { fullSize } from "../state/picture";
import { isTable, type PathStep } from "../state/path";
import { selectedObject, selectedPixel, selectObject } from "../state/selection";

export interface Sight {
  /** none: one picture */
  compare?: Exclude<Comparison, { kind: "none" }>;
  /** where it does not stand in the middle */
  wipe?: number;
  isSideBySide?: true;
  /** with the size of the picture that it was chosen in */
  pixel?: { x: number; y: number; width: number; height: number };
  /** where it is not the first */
  object?: number;
  explain?: ExplainSight;
}

/** What Explain shows where it is not what it starts with. */
export interface ExplainSight {
  /** of the profile, with width / height of the picture that it was drawn in */
  line?: { from: Place; to: Place; aspect: number };
  isComparing?: true;
  isEncoded?: true;
  light?: number;
  channel?: Channel;
  /** what is not drawn in the picture */
  hidden?: DrawnName[];
}

const kMiddle = 0.5;
const kMostSide = 1 << 20;

function currentExplainSight({ width, height }: { width: number; height: number }): ExplainSight {
  const hidden = kDrawn.filter((name) => !drawn.value[name]);
  return {
    ...(profileLine.value && width > 0 ? { line: { ...profileLine.value, aspect: width / height } } : {}),
    ...(isProfileComparing.value ? { isComparing: true } : {}),
    ...(isProfileEncoded.value ? { isEncoded: true } : {}),
    ...(chosenLight.value === undefined ? {} : { light: chosenLight.value }),
    ...(chosenChannel.value === undefined ? {} : { channel: chosenChannel.value }),
    ...(hidden.length > 0 ? { hidden } : {}),
  };
}

/** The place in a picture of another shape that shows the same, as movedPixel() finds a pixel again. */
function movedPlace({ x, y }: Place, from: number, to: number): Place {
  if (from === to) {
    return { x, y }; // to the last bit: a link that is opened stays as it is
  }
  return { x: Math.min(1, Math.max(0, (x - 0.5) * (from / to) + 0.5)), y };
}

function showExplainSight({ isComparing, isEncoded, light, channel, hidden = [] }: ExplainSight): void {
  profileLine.value = undefined;
  profileCursor.value = undefined;
  isProfileComparing.value = isComparing ?? false;
  isProfileEncoded.value = isEncoded ?? false;
  chosenLight.value = light;
  chosenChannel.value = channel;
  drawn.value = Object.fromEntries(kDrawn.map((name) => [name, !hidden.includes(name)])) as Record<DrawnName, boolean>;
}

/** Reads the signals: an effect that calls it follows them. */
export function currentSight(): Sight {
  const { value: compare } = comparison;
  const { value: pixel } = selectedPixel;
  const { width, height } = fullSize.value;
  const explain = currentExplainSight(fullSize.value);
  return {
    ...(compare.kind === "none" ? {} : { compare }),
    ...(compare.kind === "none" || wipe.value === kMiddle ? {} : { wipe: wipe.value }),
    ...(compare.kind === "none" || splitLayout.value === "wipe" ? {} : { isSideBySide: true }),
    ...(pixel && width > 0 ? { pixel: { ...pixel, width, height } } : {}),
    ...(selectedObject.value === 0 ? {} : { object: selectedObject.value }),
    ...(Object.keys(explain).length > 0 ? { explain } : {}),
  };
}

/** Of a pixel and a line that are shown once the stage has a size. */
let stopWaiting = () => {};

/** Shows it; what it does not state is as at the page's start. */
export function showSight({ compare, wipe: at, isSideBySide, pixel, object, explain = {} }: Sight): void {
  stopWaiting();
  batch(() => {
    comparison.value = compare ?? { kind: "none" };
    wipe.value = at ?? kMiddle;
    splitLayout.value = isSideBySide ? "side" : "wipe";
    selectedPixel.value = undefined;
    selectObject(object ?? 0);
    showExplainSight(explain);
  });
  const { line } = explain;
  if (pixel || line) {
    const stop = effect(() => {
      const size = fullSize.value;
      if (size.width > 0) {
        // Signals do not end an effect while it runs for the first time.
        queueMicrotask(() => stop());
        if (pixel) {
          selectedPixel.value = movedPixel(pixel, pixel, size);
        }
        if (line) {
          const to = size.width / size.height;
          profileLine.value = { from: movedPlace(line.from, line.aspect, to), to: movedPlace(line.to, line.aspect, to) };
        }
      }
    });
    stopWaiting = stop;
  }
}

const isStep = (step: unknown): step is PathStep => typeof step === "string" || Number.isInteger(step);

function readChanges(value: unknown): Changes | undefined {
  const isChange = (entry: unknown): entry is Changes[number] =>
    Array.isArray(entry) &&
    entry.length <= 2 &&
    (typeof entry[0] === "string" || (Array.isArray(entry[0]) && entry[0].length > 0 && entry[0].every(isStep)));
  return Array.isArray(value) && value.every(isChange) ? value : undefined;
}

function readComparison(value: unknown): Sight["compare"] {
  if (!isTable(value)) {
    return undefined;
  }
  const show = (["gpu", "wipe", "difference"] as const).find((word) => word === value["show"]);
  const gain = ([1, 8, 64] as const).find((times) => times === value["gain"]);
  if (value["kind"] === "gpu" && show && gain) {
    return { kind: "gpu", show, gain };
  }
  const [left, right] = [readChanges(value["left"]), readChanges(value["right"])];
  return value["kind"] === "settings" && left && right ? { kind: "settings", left, right } : undefined;
}

function readPixel(value: unknown): Sight["pixel"] {
  if (!isTable(value)) {
    return undefined;
  }
  const numbers = [value["x"], value["y"], value["width"], value["height"]];
  if (!numbers.every((n): n is number => Number.isInteger(n) && (n as number) >= 0 && (n as number) < kMostSide)) {
    return undefined;
  }
  const [x, y, width, height] = numbers as [number, number, number, number];
  return x < width && y < height ? { x, y, width, height } : undefined;
}

const isShare = (value: unknown): value is number => typeof value === "number" && value >= 0 && value <= 1;
const isPlace = (value: unknown): value is { x: number; y: number } => isTable(value) && isShare(value["x"]) && isShare(value["y"]);

function readLine(value: unknown): ExplainSight["line"] {
  if (!isTable(value)) {
    return undefined;
  }
  const { from, to, aspect } = value;
  return isPlace(from) && isPlace(to) && typeof aspect === "number" && aspect > 1 / kMostSide && aspect < kMostSide
    ? { from: { x: from.x, y: from.y }, to: { x: to.x, y: to.y }, aspect }
    : undefined;
}

function readExplainSight(value: unknown): ExplainSight {
  const table = isTable(value) ? value : {};
  const line = readLine(table["line"]);
  const channel = ([0, 1, 2] as const).find((number) => number === table["channel"]);
  const { light, hidden: names } = table;
  const hidden = kDrawn.filter((name) => Array.isArray(names) && names.includes(name));
  return {
    ...(line ? { line } : {}),
    ...(table["isComparing"] === true ? { isComparing: true } : {}),
    ...(table["isEncoded"] === true ? { isEncoded: true } : {}),
    ...(Number.isInteger(light) && (light as number) >= 0 ? { light: light as number } : {}),
    ...(channel === undefined ? {} : { channel }),
    ...(hidden.length > 0 ? { hidden } : {}),
  };
}

/** Of a link: what is not understood is left out. */
export function readSight(value: unknown): Sight {
  const table = isTable(value) ? value : {};
  const [compare, pixel] = [readComparison(table["compare"]), readPixel(table["pixel"])];
  const { wipe: at, object } = table;
  const explain = readExplainSight(table["explain"]);
  return {
    ...(compare ? { compare } : {}),
    ...(isShare(at) ? { wipe: at } : {}),
    ...(table["isSideBySide"] === true ? { isSideBySide: true } : {}),
    ...(pixel ? { pixel } : {}),
    ...(Number.isInteger(object) && (object as number) > 0 ? { object: object as number } : {}),
    ...(Object.keys(explain).length > 0 ? { explain } : {}),
  };
}
