// Every lesson against the engine itself: where a step begins its question is open, what it gives as its solution passes its own check, and
// what is wrong is answered with help.
import { beforeAll, describe, expect, test } from "vitest";
import { Bench, changed, type BenchEngine } from "../../../src/tour/bench";
import { lessons } from "../../../src/tour/lessons";
import { isNumberRight, sceneOf, type Lesson, type Step, type Text } from "../../../src/tour/lesson";
import { isEngineBuilt, nodeEngine } from "../node-engine";

let engine: BenchEngine;
beforeAll(async () => {
  if (isEngineBuilt) {
    engine = await nodeEngine();
  }
});

const kSteps: [string, Lesson, number, Step][] = lessons.flatMap((lesson) =>
  lesson.steps.map((step, index): [string, Lesson, number, Step] => [`${lesson.id} ${index + 1}: ${step.title.en}`, lesson, index, step]),
);

/** All texts of a value, however deep. */
function textsOf(value: unknown): Text[] {
  if (typeof value !== "object" || value === null) {
    return [];
  }
  if ("en" in value && "it" in value) {
    return [value as Text];
  }
  return Object.values(value).flatMap(textsOf);
}

describe("what the lessons say", () => {
  test("there are eight, with names of their own", () => {
    expect(lessons).toHaveLength(8);
    expect(new Set(lessons.map(({ id }) => id)).size).toBe(lessons.length);
  });

  test.each(lessons.map((lesson) => [lesson.id, lesson] as const))("%s has 3 to 6 steps and ends with a question", (_, lesson) => {
    expect(lesson.steps.length).toBeGreaterThanOrEqual(3);
    expect(lesson.steps.length).toBeLessThanOrEqual(6);
    expect(lesson.steps.at(-1)!.ask).toBeDefined();
    expect(lesson.steps.at(-1)!.title.en).toMatch(/^Question/);
    expect(lesson.steps.at(-1)!.title.it).toMatch(/^Domanda/);
  });

  test("both languages have every text, with the same formulas", () => {
    for (const text of lessons.flatMap(textsOf)) {
      expect(text.en === "", text.en).toBe(text.it === "");
      const formulas = (words: string) =>
        [...words.matchAll(/\$([^$]*)\$/g)]
          .map(([, tex]) => tex!.replaceAll("\\ ", "").replaceAll("{,}", ".").replaceAll(";", ",").replace(/\s/g, ""))
          .sort();
      expect((text.en.match(/\$/g) ?? []).length % 2, text.en).toBe(0);
      expect(formulas(text.it), text.it).toEqual(formulas(text.en));
    }
  });
});

describe.skipIf(!isEngineBuilt)("what the lessons ask", () => {
  test.each(kSteps)("%s", async (_, lesson, index, step) => {
    const start = sceneOf(lesson, index);
    const bench = new Bench(engine, start);
    for (const { letter, at } of step.marks ?? []) {
      expect(await bench.at(at), `the surface at ${letter} is seen`).toBeDefined();
    }
    if (step.comparison?.kind === "settings") {
      for (const side of [step.comparison.left, step.comparison.right]) {
        expect((await bench.with(side).picture()).pixelsCovered).toBeGreaterThan(0);
      }
    }
    const { ask } = step;
    if (ask?.kind === "task") {
      expect((await ask.check(bench)).ok, "before anything is done").toBe(false);
      const { solution } = ask;
      if (solution.kind === "change") {
        const changes = typeof solution.changes === "function" ? await solution.changes(bench) : solution.changes;
        expect(await ask.check(new Bench(engine, changed(start, changes), start))).toMatchObject({ ok: true });
      } else {
        const request = { scene: start, width: 640, height: 480, samples: 1 };
        const place = (await bench.pixelOf(await solution.at(bench)))!;
        const pixel = { request, x: Math.floor(((place.x + 0.5) * 640) / 240), y: Math.floor(((place.y + 0.5) * 640) / 240) };
        expect(await ask.check(new Bench(engine, start, start, pixel))).toMatchObject({ ok: true });
        const background = { request, x: 0, y: 0 };
        expect(await ask.check(new Bench(engine, start, start, background))).toMatchObject({ ok: false });
      }
    } else if (ask?.kind === "choice") {
      const answer = await ask.answer(bench);
      expect(ask.options[answer]).toBeDefined();
      ask.options.forEach(({ reply }, option) => expect(reply.en !== "", `reply to ${option}`).toBe(option !== answer));
    } else if (ask?.kind === "number") {
      const answer = await ask.answer(bench);
      expect(isNumberRight(ask, answer, answer)).toBe(true);
      expect(isNumberRight(ask, answer * 1.5, answer)).toBe(false);
      expect(isNumberRight(ask, answer * 0.5, answer)).toBe(false);
      for (const { fits } of ask.slips) {
        expect(fits(answer, answer), "a slip is not the answer").toBe(false);
      }
    }
    if (step.reveal?.scene) {
      expect((await bench.with(step.reveal.scene).picture()).pixelsCovered).toBeGreaterThan(0);
    }
  });
});
