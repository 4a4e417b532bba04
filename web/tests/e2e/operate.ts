// A control of one key of the scene file, operated as a person does: every widget that its row has, by its kind in the engine's table.
import type { Page } from "playwright-core";
import { expect } from "vitest";
import type { Option, SceneDoc } from "../../src/engine/types";
import { valueAt } from "../../src/state/path";
import { settled } from "./lab";
import "./window";

export interface Control {
  /** in the table of options: `lights[].cutoff` */
  key: string;
  /** where the scene that is open states it: `lights[1].cutoff`; the key itself where it has no lists */
  path?: string;
  /** what is typed into the first field, or picked as a colour, where the kind alone does not say it */
  type?: number | string;
  /** it is stated, and the page's picture does not show it: a name, what the path tracer alone draws */
  unseen?: true;
  /** a slider's step; a page, of whole numbers an arrow's, unless that would go too far */
  slideBy?: "Arrow";
  /** of a word's choices, those that look alike in this scene */
  alike?: readonly string[];
}

export interface Desk {
  page: Page;
  options: ReadonlyMap<string, Option>;
  /** the scene as it was opened, and its picture */
  base: { scene: SceneDoc; picture: string };
}

const kPicked = "#c08040";

export const rowOf = (key: string): string => `option-${key.replaceAll("[]", "").replaceAll("*", "x").replaceAll(".", "-")}`;
export const sceneNow = (page: Page): Promise<SceneDoc> => page.evaluate(() => window.lustro.scene.value);
export const stated = async (page: Page, path: string): Promise<unknown> => valueAt(await sceneNow(page), path);

/** A mark of the full picture of the scene as it is now: equal for equal bytes. */
export async function pictureMark(page: Page): Promise<string> {
  await settled(page);
  return page.evaluate(() => {
    const { bytes, width, height } = window.lustro.picture.value!;
    let mark = 0x811c9dc5;
    for (const pixel of new Uint32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4)) {
      mark = Math.imul(mark ^ pixel, 0x01000193);
    }
    return `${width}x${height} ${(mark >>> 0).toString(16)}`;
  });
}

/** The engine's own table, by `shading.lighting`. */
export async function optionTable(page: Page): Promise<Map<string, Option>> {
  const groups = await page.evaluate(() => window.lustro.engine.value!.options());
  return new Map(
    groups.flatMap(({ path, options }) => options.map((option) => [path === "" ? option.key : `${path}.${option.key}`, option])),
  );
}

/** Back to the scene as it was opened, by the page's own undo. */
export async function undoAll({ page, base }: Desk): Promise<void> {
  await page.getByTestId("undo").evaluate(async (button: HTMLButtonElement) => {
    while (!button.disabled) {
      button.click();
      await new Promise(requestAnimationFrame);
    }
  });
  expect(await sceneNow(page), "undo leads back to the beginning").toEqual(base.scene);
}

/** Types into a field, and leaves it by Enter. */
export async function type(page: Page, testid: string, text: string | number): Promise<void> {
  const field = page.getByTestId(testid);
  await field.fill(String(text));
  await field.press("Enter");
}

/** Operates all widgets of a key's row; each must state the key, and change the picture where it can be seen. Ends where it began. */
export async function operate(desk: Desk, control: Control): Promise<void> {
  const { page, base } = desk;
  const { key, path = key } = control;
  const option = desk.options.get(key)!;
  const row = rowOf(key);
  const input = `${row}-input`;
  const seen = async (what: string): Promise<string> => {
    const mark = await pictureMark(page);
    if (control.unseen) {
      expect(mark, `${what}: the picture stays`).toBe(base.picture);
    } else {
      expect(mark, `${what}: the picture changes`).not.toBe(base.picture);
    }
    return mark;
  };
  const says = async (what: string, value: unknown) => expect(await stated(page, path), what).toEqual(value);

  switch (option.kind) {
    case "boolean": {
      const before = valueAt(base.scene, path) ?? option.default.startsWith("true");
      await page.getByTestId(input).press("Space");
      await says("by the space bar", !before);
      await seen("switched");
      await page.getByTestId(input).click();
      await says("by a click", before);
      break;
    }
    case "integer":
    case "number":
      if (option.allowed?.length) {
        await chooseEach(desk, control, option.allowed.map(String), Number);
      } else {
        await numberRow(desk, control, says, seen);
      }
      break;
    case "vector":
    case "pair":
    case "triple": {
      const axes = { vector: "xyz", pair: "uv", triple: "rgb" }[option.kind];
      for (const [i, axis] of [...axes].entries()) {
        const typed = Number(control.type ?? 0.37) + i / 8;
        await type(page, `${input}-${axis}`, typed);
        expect(((await stated(page, path)) as number[])[i], axis).toBe(typed);
      }
      await seen("typed");
      break;
    }
    case "color":
    case "color_alpha":
      await colorRow(desk, control, says, seen);
      break;
    case "wrap": {
      const before = String(valueAt(base.scene, path) ?? option.default);
      const other = option.words.map(({ word }) => word).filter((word) => word !== before);
      const looks = [base.picture];
      for (const word of other) {
        await page.getByTestId(`${input}-u`).selectOption(word);
        await says("along u", [word, before]);
        looks.push(await pictureMark(page));
        await page.getByTestId(`${input}-v`).selectOption(word);
        await says("along both", word);
        looks.push(await pictureMark(page));
        await page.getByTestId(`${input}-u`).selectOption(before);
        await says("along v", [before, word]);
        looks.push(await pictureMark(page));
        await page.getByTestId(`${input}-v`).selectOption(before);
      }
      await says("as before", before);
      expect(new Set(looks).size, "each looks its own way").toBe(looks.length);
      break;
    }
    case "word":
      await chooseEach(
        desk,
        control,
        option.words.map(({ word }) => word),
        String,
      );
      break;
    case "terms":
      for (const { word } of option.words) {
        await page.getByTestId(`${row}-${word}`).click();
        await says(
          `without ${word}`,
          option.words.map((term) => term.word).filter((term) => term !== word),
        );
        await seen(`without ${word}`);
        await page.getByTestId(`${row}-${word}`).press("Enter");
        await says("all of them", undefined);
      }
      await page.getByTestId(`${row}-${option.words[0]!.word}`).click();
      break;
    case "text":
      await page.getByTestId(input).fill("");
      await page.getByTestId(input).pressSequentially(String(control.type ?? "a name"));
      await says("typed", control.type ?? "a name");
      await seen("typed");
      break;
    case "matrix":
    case "affine": {
      const count = option.kind === "matrix" ? 12 : 6;
      for (let i = 0; i < count; ++i) {
        const typed = (i % (option.kind === "matrix" ? 5 : 4) === 0 ? 1.1 : 0.1) + i / 100;
        await type(page, `${row}-${i}`, typed);
        expect(((await stated(page, path)) as number[])[i], `entry ${i}`).toBe(typed);
      }
      await seen("typed");
      break;
    }
    default:
      throw new Error(`${key}: nobody knows how to operate a ${option.kind}`);
  }

  if (!(await page.getByTestId(`${row}-reset`).isVisible())) {
    throw new Error(`${key}: there is no way back to the default`);
  }
  await page.getByTestId(`${row}-reset`).click();
  await says("back to the default", undefined);
}

type Says = (what: string, value: unknown) => Promise<void>;
type Seen = (what: string) => Promise<string>;

async function numberRow(
  { page, options }: Desk,
  { key, path = key, type: typed, slideBy }: Control,
  says: Says,
  seen: Seen,
): Promise<void> {
  const row = rowOf(key);
  const number = Number(typed);
  if (!Number.isFinite(number)) {
    throw new Error(`${key}: no number to type`);
  }
  await type(page, `${row}-input`, number);
  await says("typed", number);
  await seen("typed");

  await page.getByTestId(`${row}-input`).press("ArrowUp");
  const up = await stated(page, path);
  await page.getByTestId(`${row}-input`).press("ArrowDown");
  expect(up, "arrow up").not.toBe(await stated(page, path));

  await page.getByTestId(`${row}-input`).fill("never");
  expect(await page.getByTestId(`${row}-input`).getAttribute("aria-invalid")).toBe("true");
  await page.getByTestId(`${row}-input`).press("Escape");
  const { minimum } = options.get(key)!;
  if (minimum !== undefined) {
    const before = await stated(page, path);
    await page.getByTestId(`${row}-input`).fill(String(minimum - 1));
    await says("below its range nothing is taken", before);
    await page.getByTestId(`${row}-input`).press("Escape");
  }

  const slider = page.getByTestId(`${row}-slider`);
  if ((await slider.count()) > 0) {
    const before = Number(await stated(page, path));
    const isHigh = Number(await slider.inputValue()) > 500;
    const isWhole = options.get(key)!.kind === "integer";
    await slider.press(slideBy || isWhole ? (isHigh ? "ArrowLeft" : "ArrowRight") : isHigh ? "PageDown" : "PageUp");
    const after = Number(await stated(page, path));
    expect(isHigh ? before - after : after - before, "the slider by its keys").toBeGreaterThan(0);
    await seen("by the slider");
  }
}

async function colorRow({ page, options }: Desk, { key, path = key }: Control, says: Says, seen: Seen): Promise<void> {
  const input = `${rowOf(key)}-input`;
  const isText = async () => typeof (await stated(page, path)) === "string";
  const channel = async (i: number) => ((await stated(page, path)) as number[])[i];
  await page.getByTestId(input).fill("#123456");
  if (!(await isText())) {
    await page.getByTestId(`${input}-space`).click();
  }
  expect(await isText(), "the badge changes the notation").toBe(true);
  await page.getByTestId(input).fill(kPicked);
  await says("picked", kPicked);
  await seen("picked");
  await type(page, `${input}-text`, "#20a0e0");
  await says("typed", "#20a0e0");
  await seen("typed");
  await page.getByTestId(`${input}-space`).click();
  expect(await isText(), "the badge changes it back").toBe(false);
  expect(await channel(0)).toBeCloseTo(0.01444, 4);
  for (const [i, letter] of ["r", "g", "b"].entries()) {
    await type(page, `${input}-${letter}`, 0.25 * (i + 1));
    expect(await channel(i), letter).toBe(0.25 * (i + 1));
  }
  if (options.get(key)!.kind === "color_alpha") {
    await type(page, `${input}-alpha`, 0.5);
    await says("half clear", [0.25, 0.5, 0.75, 0.5]);
  }
  await seen("by its numbers");
}

/** Every choice, each with a picture of its own. */
async function chooseEach(
  { page, options, base }: Desk,
  { key, path = key, unseen, alike = [] }: Control,
  words: readonly string[],
  read: (word: string) => unknown,
): Promise<void> {
  const input = page.getByTestId(`${rowOf(key)}-input`);
  const isList = (await input.evaluate((element) => element.tagName)) === "SELECT";
  const before = valueAt(base.scene, path) ?? (options.get(key)!.optional ? "" : options.get(key)!.default);
  const marks = new Map([[String(before), base.picture]]);
  // The one that holds comes last: choosing it first would be no change.
  for (const word of [...words.filter((w) => w !== String(before)), ...words.filter((w) => w === String(before))]) {
    if (isList) {
      await input.selectOption(word);
    } else {
      await input.locator("label", { has: page.getByTestId(`${rowOf(key)}-input-${word}`) }).click();
    }
    expect(await stated(page, path), word).toEqual(read(word));
    marks.set(word, await pictureMark(page));
  }
  if (options.get(key)!.optional) {
    await (isList ? input.selectOption("") : input.locator("label").first().click());
    expect(await stated(page, path), "as the scene").toBe(undefined);
    await (isList ? input.selectOption(words[0]!) : input.locator("label").last().click());
  }
  const looks = [...marks].filter(([word]) => !alike.includes(word)).map(([, mark]) => mark);
  expect(new Set(looks).size, `pictures of ${[...marks].map((mark) => mark.join(" ")).join(", ")}`).toBe(unseen ? 1 : looks.length);
}
