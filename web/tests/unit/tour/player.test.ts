// The tour as it runs, with the engine itself and the page's own state, but without a page.
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from "vitest";
import type { Engine } from "../../../src/engine/types";
import { engine } from "../../../src/state/engine";
import { comparison } from "../../../src/state/compare";
import { fullSize, picture } from "../../../src/state/picture";
import { canUndo, redo, resetScene, scene, undo, update } from "../../../src/state/scene";
import { selectedPixel } from "../../../src/state/selection";
import { lessons } from "../../../src/tour/lessons";
import * as tour from "../../../src/tour/player";
import { progress } from "../../../src/tour/progress";
import { isEngineBuilt, nodeEngine } from "../node-engine";

const kOwn = { objects: [{ mesh: "primitive:torus", material: "jade" }] };
let stop: (() => void)[] = [];

beforeAll(async () => {
  if (isEngineBuilt) {
    engine.value = (await nodeEngine()) as Engine;
  }
});
beforeEach(() => {
  resetScene(kOwn);
  update("ambient", [0.3, 0.3, 0.3]);
  fullSize.value = { width: 400, height: 300 };
  stop = [tour.watchTasks(), tour.watchScene()];
});
afterEach(() => {
  tour.leave();
  stop.forEach((end) => end());
});

const lessonIndex = (id: string) => lessons.findIndex((lesson) => lesson.id === id);
/** The stage draws what is shown. */
const draw = async () => (picture.value = await engine.value!.render({ scene: scene.value, width: 400, height: 300, samples: 1 }));

describe("numbers as people write them", () => {
  test.each([
    ["42", 42],
    [" 42.5° ", 42.5],
    ["42,5", 42.5],
    ["-0.2", -0.2],
    ["−0,2", -0.2],
    [".5", 0.5],
    ["1e2", 100],
    ["", undefined],
    ["4 2", undefined],
    ["forty", undefined],
    ["1,000.5", undefined],
  ])("%j", (text, value) => expect(tour.parsedNumber(text)).toBe(value));
});

test("leaving brings the reader's scene back, with its steps", () => {
  const before = scene.value;
  tour.startLesson(0);
  expect(scene.value).not.toEqual(before);
  expect(canUndo.value).toBe(false);
  update("ambient", [1, 1, 1]);
  tour.nextStep();
  tour.leave();
  expect(scene.value).toBe(before);
  undo();
  expect(scene.value).toEqual(kOwn);
  redo();
  expect(scene.value).toBe(before);
});

test("a lesson's scene can be kept, and undone", () => {
  const before = scene.value;
  tour.startLesson(1);
  const kept = scene.value;
  tour.leave(true);
  expect(scene.value).toEqual(kept);
  undo();
  expect(scene.value).toBe(before);
});

test("a scene that is opened meanwhile ends the tour and stays", () => {
  tour.startLesson(0);
  resetScene({ objects: [{ mesh: "primitive:cube" }] });
  expect(tour.place.value).toBeUndefined();
  expect(scene.value.objects[0]!.mesh).toBe("primitive:cube");
});

test("a step begins the same, whatever was done before it", () => {
  tour.startLesson(0);
  update("objects[0].mesh", "primitive:cube");
  tour.nextStep();
  expect(scene.value.objects[0]!.mesh).toBe("primitive:teapot");
  tour.previousStep();
  expect(scene.value.objects[0]!.mesh).toBe("primitive:teapot");
});

test("a comparison lasts for its step alone", () => {
  tour.startLesson(lessonIndex("exponent"));
  expect(comparison.value.kind).toBe("none");
  tour.nextStep();
  expect(comparison.value.kind).toBe("settings");
  tour.nextStep();
  expect(comparison.value.kind).toBe("none");
});

describe.skipIf(!isEngineBuilt)("answers", () => {
  test("a task is done by doing it; before that it says how far one is", async () => {
    tour.startLesson(0);
    expect(tour.feedback.value).toBeUndefined();
    update("ambient", [0.02, 0.02, 0.02]);
    await vi.waitFor(() => expect(tour.feedback.value?.kind).toBe("note"));
    expect(tour.feedback.value!.texts[0]!.en).toContain("0.02");
    expect(tour.outcome.value).toBe("open");
    update("ambient", [0.5, 0.5, 0.5]);
    await vi.waitFor(() => expect(tour.outcome.value).toBe("right"));
  });

  test("a pixel that is chosen is looked at", async () => {
    tour.startLesson(lessonIndex("lambert"));
    selectedPixel.value = { x: 0, y: 0 };
    await vi.waitFor(() => expect(tour.feedback.value?.texts[0]!.en).toContain("background"));
    selectedPixel.value = { x: 200, y: 150 };
    await vi.waitFor(() => expect(tour.feedback.value?.texts[0]!.en).toContain("0.64"));
    expect(tour.outcome.value).toBe("open");
  });

  test("numbers: no number, a slip, too much, right with a comma", async () => {
    const index = lessonIndex("edges");
    tour.startLesson(index);
    for (let i = 1; i < lessons[index]!.steps.length; ++i) {
      tour.nextStep();
    }
    await tour.answerNumber("many");
    expect(tour.feedback.value).toMatchObject({ kind: "wrong", texts: [{ en: "That is no number." }] });
    await tour.answerNumber("22");
    expect(tour.feedback.value!.texts[0]!.en).toContain("Near");
    await tour.answerNumber("180");
    expect(tour.feedback.value!.texts[0]!.en).toContain("Too much");
    expect(tour.outcome.value).toBe("open");
    await tour.answerNumber("23,0°");
    expect(tour.outcome.value).toBe("right");
    expect(progress.value.done).toContain("edges");
  });

  test("an answer that comes after the step is gone is not counted", async () => {
    const index = lessonIndex("interpolation");
    tour.startLesson(index);
    const late = tour.choose(2);
    tour.nextStep();
    await late;
    expect(tour.outcome.value).toBe("open");
  });

  test.each(lessons.map(({ id }, index) => [id, index] as const))(
    "%s: wrong options are replied to, and all of it can be shown",
    async (_, index) => {
      tour.startLesson(index);
      for (let number = 0; number < lessons[index]!.steps.length; ++number) {
        const { ask } = lessons[index]!.steps[number]!;
        await draw();
        if (ask?.kind === "choice") {
          for (let option = 0; option < ask.options.length && tour.outcome.value === "open"; ++option) {
            await tour.choose(option);
            expect(tour.feedback.value!.texts.length).toBeGreaterThan(0);
          }
          expect(tour.outcome.value).toBe("right");
          expect(tour.wrongOptions.value).not.toContain(tour.rightOption.value);
        } else if (ask) {
          await tour.showAnswer();
          expect(tour.outcome.value).toBe("shown");
          if (ask.kind === "task" && ask.solution.kind === "pick") {
            expect(selectedPixel.value).toBeDefined();
          }
        }
        tour.nextStep();
      }
      expect(progress.value.done).toContain(lessons[index]!.id);
    },
  );
});
