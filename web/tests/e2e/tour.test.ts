// The guided tour in the browser, as a learner walks it: in English by the page's own means (clicks, keys, drags; wrong answers first), in
// Italian by asking for each answer. Every control that a step speaks of must be there.
import { beforeAll, describe, expect, test } from "vitest";
import type { Page } from "playwright-core";
import type { SceneDoc, Vec3 } from "../../src/engine/types";
import { Bench, type BenchEngine } from "../../src/tour/bench";
import { sceneOf, type Lesson, type Quantity, type Step, type Task } from "../../src/tour/lesson";
import { lessons } from "../../src/tour/lessons";
import { nodeEngine } from "../unit/node-engine";
import { openLab, settled, useBrowser } from "./lab";
import "./window";

useBrowser();

let engine: BenchEngine;
beforeAll(async () => {
  engine = await nodeEngine();
});

const card = (page: Page) => page.getByTestId("tour-card");
const outcome = (page: Page) => page.locator('.tour-ask[data-outcome="right"], .tour-ask[data-outcome="shown"]');

/** Clicks the place of the picture that shows a place of the world. */
async function clickPlace(page: Page, at: Vec3): Promise<void> {
  await settled(page);
  const place = await page.evaluate((point) => {
    const { eye, right, up, forward, pixelsPerUnit, width, height } = window.lustro.picture.value!.view;
    const dot = (axis: readonly number[]) => axis.reduce((sum, a, i) => sum + a * (point[i]! - eye[i]!), 0);
    const scale = pixelsPerUnit / dot(forward);
    return { x: 0.5 + (dot(right) * scale) / width, y: 0.5 - (dot(up) * scale) / height };
  }, at);
  const box = (await page.getByTestId("stage").boundingBox())!;
  await page.mouse.click(box.x + place.x * box.width, box.y + place.y * box.height);
}

/** What a learner does with the page's own controls, by lesson and step; elsewhere the scene is changed from the console. */
const kByHand: Record<string, (page: Page) => Promise<void>> = {
  "ambient 1": async (page) => {
    await page.getByTestId("option-ambient").getByRole("textbox").first().fill("#bbbbbb");
    await page.keyboard.press("Enter");
  },
  "lambert 4": (page) => drag(page, 220),
  "phong 1": async (page) => page.getByTestId("option-shading-lighting-input-phong").click(),
  "phong 3": async (page) => {
    await page.getByTestId("stage").focus();
    for (let i = 0; i < 16; ++i) {
      await page.keyboard.press("ArrowLeft");
    }
  },
  "phong 4": async (page) => page.getByTestId("material-gold").click(),
  "exponent 1": (page) => type(page, "option-materials-x-shininess", "80"),
  "exponent 3": async (page) => page.getByTestId("option-shading-normalized-input").click(),
  "exponent 4": (page) => type(page, "option-materials-x-shininess", "0"),
  "blinn-phong 1": async (page) => page.getByTestId("option-shading-lighting-input-blinn-phong").click(),
  "interpolation 2": async (page) => page.getByTestId("option-shading-interpolation-input-gouraud").click(),
  "interpolation 3": (page) => type(page, "object-segments", "128"),
  "interpolation 4": async (page) => page.getByTestId("option-shading-interpolation-input-phong").click(),
  "edges 3": (page) => type(page, "option-shading-crease", "60"),
  "edges 4": (page) => type(page, "option-shading-crease", "40"),
  "lights 3": (page) => type(page, "option-lights-cutoff", "32"),
};

async function type(page: Page, testid: string, text: string): Promise<void> {
  const field = page.getByTestId(testid).getByTestId(`${testid}-input`);
  await field.fill(text);
  await field.press("Enter");
}

async function drag(page: Page, by: number): Promise<void> {
  const box = (await page.getByTestId("stage").boundingBox())!;
  await page.mouse.move(box.x + box.width / 2 - by / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + by / 2, box.y + box.height / 2, { steps: 5 });
  await page.mouse.up();
}

async function doTask(page: Page, name: string, ask: Task, start: SceneDoc): Promise<void> {
  const bench = new Bench(engine, start);
  const byHand = kByHand[name];
  if (byHand) {
    await byHand(page);
  } else if (ask.solution.kind === "pick") {
    await clickPlace(page, await ask.solution.at(bench));
  } else {
    const { changes } = ask.solution;
    for (const [path, value] of typeof changes === "function" ? await changes(bench) : changes) {
      await page.evaluate(([place, next]) => window.lustro.update(place as string, next), [path, value] as const);
    }
  }
}

async function answerNumber(page: Page, ask: Quantity, start: SceneDoc): Promise<void> {
  const answer = await ask.answer(new Bench(engine, start));
  const said = page.getByTestId("tour-feedback");
  for (const wrong of ["some", String(Math.round(answer * 3)), "0.001"]) {
    await page.getByTestId("tour-answer").fill(wrong);
    await page.getByTestId("tour-check").click();
    await expect.poll(() => said.getAttribute("data-kind")).toBe("wrong");
    expect((await said.innerText()).length).toBeGreaterThan(5);
  }
  await page.getByTestId("tour-answer").fill(String(Math.round(answer)));
  await page.getByTestId("tour-answer").press("Enter");
}

async function chooseOption(page: Page, step: Step, right: number): Promise<void> {
  const { ask } = step;
  for (let option = 0; ask?.kind === "choice" && option < ask.options.length; ++option) {
    if (option !== right) {
      await page.getByTestId(`tour-option-${option}`).click();
      await expect.poll(() => page.getByTestId(`tour-option-${option}`).getAttribute("data-state")).toBe("wrong");
      expect((await page.getByTestId("tour-feedback").innerText()).length).toBeGreaterThan(5);
    }
  }
  await page.getByTestId(`tour-option-${right}`).click();
}

async function beginLesson(page: Page, lesson: Lesson): Promise<void> {
  await page.getByTestId("tour").click();
  await page.getByTestId(`tour-lesson-${lesson.id}`).click();
  await card(page).waitFor();
}

/** What holds of every step, in every language. */
async function lookAt(page: Page, step: Step, language: "en" | "it"): Promise<void> {
  const heading = card(page).getByRole("heading", { name: step.title[language] });
  await heading.waitFor();
  await expect
    .poll(() => heading.evaluate((element) => element === document.activeElement), { message: "the step has the focus" })
    .toBe(true);
  // on narrow screens its panel opens when it is asked for
  if (step.control && page.viewportSize()!.width > 860) {
    await page.locator(`[data-testid="${step.control.testid}"][data-tour-target]`).waitFor({ timeout: 5000 });
  }
  for (const { letter } of step.marks ?? []) {
    await page.getByTestId(`tour-pin-${letter}`).waitFor({ state: "attached" });
  }
  expect(await card(page).locator(".katex-error").count()).toBe(0);
  const cutOff = await card(page)
    .locator(".tour-formula .x-tex")
    .evaluateAll((formulas) =>
      formulas.filter((formula) => formula.scrollWidth > formula.clientWidth).map((formula) => formula.textContent),
    );
  expect(cutOff, "formulas fit the card").toEqual([]);
  expect(await page.evaluate(() => document.querySelector(".header")!.getBoundingClientRect().y), "the page stays where it is").toBe(0);
  expect(await page.locator(".message").allInnerTexts(), "lessons cause no notes").toEqual([]);
  expect(await card(page).innerText()).not.toMatch(/[$`]|\*\*|undefined/);
}

describe("eight lessons by hand", () => {
  test.each(lessons.map((lesson) => [lesson.id, lesson] as const))("%s", async (_, lesson) => {
    const lab = await openLab();
    const { page } = lab;
    const before = await page.evaluate(() => JSON.stringify(window.lustro.scene.value));
    await beginLesson(page, lesson);
    for (const [index, step] of lesson.steps.entries()) {
      const start = sceneOf(lesson, index);
      await lookAt(page, step, "en");
      expect(await outcome(page).count(), "nothing is answered yet").toBe(0);
      const { ask } = step;
      if (ask?.kind === "task") {
        await doTask(page, `${lesson.id} ${index + 1}`, ask, start);
      } else if (ask?.kind === "choice") {
        await chooseOption(page, step, await ask.answer(new Bench(engine, start)));
      } else if (ask) {
        await answerNumber(page, ask, start);
      }
      await page
        .locator('.tour-ask[data-outcome="right"]')
        .waitFor({ timeout: 10_000 })
        .catch((problem: unknown) => {
          throw new Error(`step ${index + 1} is not solved: ${String(problem)}`);
        });
      if (index + 1 < lesson.steps.length) {
        await page.getByTestId("tour-next").click();
      }
    }
    await page.getByTestId("tour-leave").click();
    await card(page).waitFor({ state: "detached" });
    expect(await page.evaluate(() => JSON.stringify(window.lustro.scene.value))).toBe(before);
    await page.getByTestId("tour").click();
    expect(await page.getByTestId(`tour-lesson-${lesson.id}`).getAttribute("data-done")).toBe("true");
    await lab.close();
  });
});

test("eight lessons in Italian, shown by the tour itself", async () => {
  const lab = await openLab({ locale: "it-IT", isolated: false, viewport: { width: 1000, height: 700 } }); // the narrowest card
  const { page } = lab;
  await beginLesson(page, lessons[0]!);
  for (const [number, lesson] of lessons.entries()) {
    for (const [index, step] of lesson.steps.entries()) {
      await lookAt(page, step, "it");
      const { ask } = step;
      if (ask?.kind === "choice") {
        await chooseOption(page, step, await ask.answer(new Bench(engine, sceneOf(lesson, index))));
      } else if (ask) {
        await page.getByTestId("tour-hint").click();
        await settled(page);
        await page.getByTestId("tour-show").click();
      }
      await outcome(page).waitFor({ timeout: 10_000 });
      expect(await page.getByTestId("tour-feedback").innerText()).toContain(
        ask?.kind === "choice" ? "Giusto" : ask?.kind === "number" ? "La risposta" : "Ecco come",
      );
      const isLast = index + 1 === lesson.steps.length;
      if (!isLast) {
        await page.getByTestId("tour-next").click();
      } else if (number + 1 < lessons.length) {
        await page.getByTestId("tour-next-lesson").click();
      }
    }
  }
  await page.getByTestId("tour-all").click();
  expect(await page.locator('[data-done="true"]').count()).toBe(8);
  await lab.close();
}, 120_000);

test("progress is kept, and the lesson can be left at any step", async () => {
  const lab = await openLab();
  const { page } = lab;
  await beginLesson(page, lessons[1]!);
  await page.getByTestId("tour-next").click();
  await page.getByTestId("tour-next").click();
  await page.reload();
  await page.getByTestId("tour").click();
  await page.getByTestId("tour-lesson-lambert").click();
  await card(page).getByRole("heading", { name: lessons[1]!.steps[2]!.title.en }).waitFor();
  await page.getByTestId("language").click();
  await card(page).getByRole("heading", { name: lessons[1]!.steps[2]!.title.it }).waitFor();
  await lab.close();
});

/** Letters of marks that something of the stage hides. */
const hiddenMarks = (page: Page) =>
  page.evaluate(() => {
    const tools = document.querySelector(".stage-tools")!.getBoundingClientRect();
    return [...document.querySelectorAll(".tour-pins text")]
      .filter((letter) => {
        const { x, y, right, bottom } = letter.getBoundingClientRect();
        return x < tools.right && right > tools.x && y < tools.bottom && bottom > tools.y;
      })
      .map((letter) => letter.textContent);
  });

test("eight lessons on a narrow screen", async () => {
  const lab = await openLab({ viewport: { width: 390, height: 844 }, reducedMotion: "reduce" });
  const { page } = lab;
  for (const lesson of lessons) {
    await beginLesson(page, lesson);
    for (const [index, step] of lesson.steps.entries()) {
      await lookAt(page, step, "en");
      if (step.marks) {
        await settled(page);
        expect(await hiddenMarks(page), `${lesson.id} ${index + 1}`).toEqual([]);
      }
      if (index + 1 < lesson.steps.length) {
        await page.getByTestId("tour-next").click();
      }
    }
    await page.getByTestId("tour-leave").click();
    await page.getByTestId("message-note").waitFor();
  }
  await lab.close();
});

test("narrow: a control that is asked for can be seen, and has the focus", async () => {
  const lab = await openLab({ viewport: { width: 390, height: 844 }, reducedMotion: "reduce" });
  const { page } = lab;
  await beginLesson(
    page,
    lessons.find(({ id }) => id === "exponent")!,
  );
  await page.getByTestId("tour-control").click();
  const isSeen = () =>
    page.evaluate(() => {
      const control = document.activeElement!.closest("[data-tour-target]")?.getBoundingClientRect();
      const room = document.querySelector(".panel-content")!.getBoundingClientRect();
      return control !== undefined && control.y >= room.y && control.bottom <= Math.min(room.bottom, innerHeight);
    });
  await expect.poll(isSeen, { timeout: 5000 }).toBe(true);
  await lab.close();
});

test("narrow: the place that was chosen stays chosen above the sheet, and the way on is at hand", async () => {
  const lab = await openLab({ viewport: { width: 390, height: 844 } });
  const { page } = lab;
  const lesson = lessons.find(({ id }) => id === "lambert")!;
  await beginLesson(page, lesson);
  for (const [index, way] of (["click", "show"] as const).entries()) {
    const { ask } = lesson.steps[index]!;
    if (way === "click" && ask?.kind === "task" && ask.solution.kind === "pick") {
      await clickPlace(page, await ask.solution.at(new Bench(engine, sceneOf(lesson, index))));
    } else {
      await page.getByTestId("tour-hint").click();
      await page.getByTestId("tour-show").click();
    }
    await outcome(page).waitFor({ state: "attached", timeout: 10_000 });
    await page.locator('.panel[data-open="true"]').waitFor();
    await settled(page);
    await page.getByTestId("explain").waitFor({ timeout: 5000 });
    expect(await page.getByTestId("pixel-mark").count()).toBe(1);
    expect((await page.getByTestId("stage").boundingBox())!.height, "room for the picture").toBeGreaterThan(200);
    await page.getByTestId("tour-next").click();
    await card(page)
      .getByRole("heading", { name: lesson.steps[index + 1]!.title.en })
      .waitFor();
  }
  await lab.close();
});

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

const areApart = (a: Box, b: Box) => a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height || b.y >= a.y + a.height;

test.each([
  ["wide", 1280, 800],
  ["between", 1000, 700],
  ["narrow", 390, 844],
])("no message covers the card or the panel: %s", async (_, width, height) => {
  const lab = await openLab({ viewport: { width, height }, hash: "#s=broken", reducedMotion: "reduce" });
  const { page } = lab;
  const message = page.locator(".message");
  await message.waitFor();
  const covered = async () => {
    const said = (await message.boundingBox())!;
    expect(said.x + said.width).toBeLessThanOrEqual(width);
    const places = { header: page.locator(".header"), card: card(page), panel: page.locator(".panel") };
    const names: string[] = [];
    for (const [name, place] of Object.entries(places)) {
      const box = (await place.count()) > 0 ? await place.boundingBox() : undefined;
      if (box && !areApart(said, box)) {
        names.push(name);
      }
    }
    return names;
  };
  expect(await covered(), "before the tour").toEqual([]);
  await beginLesson(page, lessons[0]!);
  expect(await covered(), "beside the tour's card").toEqual([]);
  if (width < 860) {
    await page.getByTestId("sheet").click();
    await page.locator('.panel[data-open="true"]').waitFor();
    await expect.poll(covered, { message: "above the open sheet" }).toEqual([]);
  }
  await lab.close();
});
