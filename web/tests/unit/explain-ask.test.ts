// When the engine is asked about a pixel, and what becomes of its answers.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { movedPixel, startAsking } from "../../src/explain/ask";
import { explainFailure, shownExplanation } from "../../src/explain/state";
import type { Engine, Explanation, Picture } from "../../src/engine/types";
import { engine } from "../../src/state/engine";
import { fullSize, isPictureFinal, picture } from "../../src/state/picture";
import { beginDrag } from "../../src/state/scene";
import { explanation, hoveredPixel, selectedPixel } from "../../src/state/selection";
import { panelTab } from "../../src/state/settings";
import { explained } from "../fixtures/explanations";

const { explanation: some } = explained[0]!;
let asked: { x: number; y: number; resolve: (answer: Explanation) => void; reject: (reason: unknown) => void }[] = [];
let stop = () => {};

const answerNext = async () => {
  const question = asked.shift()!;
  question.resolve({ ...some, x: question.x, y: question.y });
  await Promise.resolve();
  await Promise.resolve();
  await Promise.resolve();
};

beforeEach(() => {
  asked = [];
  engine.value = {
    explain: (_: unknown, x: number, y: number) => new Promise<Explanation>((resolve, reject) => asked.push({ x, y, resolve, reject })),
  } as unknown as Engine;
  fullSize.value = { width: 100, height: 50 };
  picture.value = {} as Picture;
  isPictureFinal.value = true;
  selectedPixel.value = undefined;
  panelTab.value = "shading";
  stop = startAsking();
});
afterEach(async () => {
  stop();
  asked.splice(0).forEach(({ reject }) => reject(new DOMException("", "AbortError")));
  await new Promise((resolve) => setTimeout(resolve));
});

describe("the chosen pixel", () => {
  it("is asked for, shown, and opens its panel", async () => {
    selectedPixel.value = { x: 3, y: 4 };
    expect(asked).toMatchObject([{ x: 3, y: 4 }]);
    expect(explanation.value).toBeUndefined();
    expect(panelTab.value).toBe("explain");
    await answerNext();
    expect(explanation.value).toMatchObject({ x: 3, y: 4 });
    expect(shownExplanation.value).toBe(explanation.value);
  });
  it("that moves on while an answer is awaited is asked for next, the ones between never", async () => {
    selectedPixel.value = { x: 1, y: 1 };
    selectedPixel.value = { x: 2, y: 1 };
    selectedPixel.value = { x: 3, y: 1 };
    expect(asked.length).toBe(1);
    await answerNext();
    expect(shownExplanation.value).toBeUndefined();
    expect(asked).toMatchObject([{ x: 3, y: 1 }]);
    await answerNext();
    expect(explanation.value).toMatchObject({ x: 3 });
  });
  it("waits for the end of a drag, and the old numbers stay until the new ones are there", async () => {
    selectedPixel.value = { x: 3, y: 4 };
    await answerNext();
    const end = beginDrag();
    expect(explanation.value).toBeUndefined();
    expect(shownExplanation.value).toMatchObject({ x: 3 });
    picture.value = {} as Picture;
    expect(asked).toEqual([]);
    end();
    expect(asked).toMatchObject([{ x: 3, y: 4 }]);
  });
  it("whose question fails says why", async () => {
    selectedPixel.value = { x: 3, y: 4 };
    asked.shift()!.reject(new Error("no memory"));
    await new Promise((resolve) => setTimeout(resolve));
    expect(explainFailure.value).toBe("no memory");
    picture.value = {} as Picture;
    await answerNext();
    expect(explainFailure.value).toBeUndefined();
  });
  it("stays on its surface when the picture's size changes", () => {
    selectedPixel.value = { x: 75, y: 40 };
    fullSize.value = { width: 60, height: 25 };
    expect(selectedPixel.value).toEqual({ x: 42, y: 20 });
    expect(movedPixel({ x: 99, y: 10 }, { width: 100, height: 50 }, { width: 40, height: 50 })).toBeUndefined();
  });
});

describe("the pixel under the pointer", () => {
  it("is asked for after a moment, on the Explain panel alone", () => {
    vi.useFakeTimers();
    hoveredPixel.value = { x: 5, y: 5 };
    vi.advanceTimersByTime(500);
    expect(asked).toEqual([]);
    panelTab.value = "explain";
    hoveredPixel.value = { x: 6, y: 5 };
    hoveredPixel.value = { x: 7, y: 5 };
    vi.advanceTimersByTime(50);
    expect(asked).toEqual([]);
    vi.advanceTimersByTime(500);
    expect(asked).toMatchObject([{ x: 7, y: 5 }]);
    vi.useRealTimers();
    hoveredPixel.value = undefined;
  });
});
