// Comparing: the engine beside the graphics card's picture of the same equation, and two settings of one scene by the same camera.
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { kPairs } from "../../src/gpu/settings";
import { pathText } from "../../src/state/path";
import { openLab, settled, useBrowser, type Lab } from "./lab";
import "./window";

useBrowser();

/** Pixels that may differ by more than 2/255: a card's grid is coarser, so silhouettes do. */
const kMostShare = 0.003;

const kScenes = ["primitive:teapot", "primitive:sphere:48", "primitive:torus:60", "primitive:cube", "primitive:plane:8"];
const kLightings = ["lambert", "phong", "blinn-phong"];
const kInterpolations = ["flat", "gouraud", "phong"];

async function set(page: Page, changes: readonly (readonly [string, unknown])[]): Promise<void> {
  await page.evaluate((list) => {
    for (const [path, value] of list) {
      window.lustro.update(path, value);
    }
  }, changes);
}

/** Until the card has drawn what the stage shows now. */
async function reported(page: Page): Promise<number> {
  await settled(page);
  const report = page.locator('[data-testid="gpu-report"][data-current="true"]');
  await report.waitFor({ timeout: 10_000 });
  return Number(await report.getAttribute("data-share"));
}

/** The mean of all colours of a canvas, 0..255. */
const brightness = (page: Page, testid: string) =>
  page.getByTestId(testid).evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let at = 0; at < data.length; at += 4) {
      sum += data[at]! + data[at + 1]! + data[at + 2]!;
    }
    return sum / (0.75 * data.length);
  });

describe("the engine beside the graphics card", () => {
  let lab: Lab;
  beforeAll(async () => {
    lab = await openLab();
    await lab.page.getByTestId("compare").click();
    await lab.page.getByTestId("compare-gpu").click();
  });
  afterAll(() => lab.close());

  test.each(kScenes)("%s", async (mesh) => {
    const { page } = lab;
    await set(page, [
      ["objects[0].mesh", mesh],
      ["image.samples", 4],
    ]);
    for (const lighting of kLightings) {
      for (const interpolation of kInterpolations) {
        await set(page, [
          ["shading.lighting", lighting],
          ["shading.interpolation", interpolation],
        ]);
        expect(await reported(page), `${lighting}, ${interpolation}`).toBeLessThanOrEqual(kMostShare);
      }
    }
  });

  test("the difference can be seen, and is the stronger the higher its gain", async () => {
    const { page } = lab;
    await page.getByTestId("gpu-show-difference").click();
    let last = 0;
    for (const gain of [1, 8, 64]) {
      await page.getByTestId(`gpu-gain-${gain}`).click();
      await reported(page);
      await expect.poll(() => brightness(page, "gpu-difference"), { timeout: 10_000 }).toBeGreaterThan(1.5 * last);
      last = await brightness(page, "gpu-difference");
    }
    await page.getByTestId("gpu-only").click();
    expect(await page.getByTestId("gpu-picture").isVisible()).toBe(true);
    await page.getByTestId("gpu-wipe").click();
  });

  test("the bar between them follows the mouse and the keys", async () => {
    const { page } = lab;
    const bar = page.getByTestId("wipe");
    const at = async () => Number(await bar.getAttribute("aria-valuenow"));
    await page.keyboard.press("Escape"); // the card of choices
    const stage = (await page.getByTestId("stage").boundingBox())!;
    const box = (await bar.boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(stage.x + stage.width * 0.25, stage.y + stage.height / 2, { steps: 4 });
    await page.mouse.up();
    expect(Math.abs((await at()) - 25)).toBeLessThanOrEqual(1);
    await bar.focus();
    const before = await at();
    await page.keyboard.press("ArrowRight");
    expect(await at()).toBe(before + 2);
    await page.keyboard.press("End");
    expect(await at()).toBe(100);
    await page.keyboard.press("Home");
    expect(await at()).toBe(0);
  });
});

/** Both sides as they are shown, and as the engine draws the two scenes by themselves with the stage's camera. */
async function sides(page: Page, left: [string, unknown][], right: [string, unknown][]): Promise<{ shown: string[]; alone: string[] }> {
  await settled(page);
  await page.locator('[data-testid="compare-base"][data-current="true"]').waitFor({ timeout: 10_000 });
  return page.evaluate(
    async (changes) => {
      const digest = async (bytes: Uint8ClampedArray<ArrayBuffer>) =>
        [...new Uint8Array(await crypto.subtle.digest("SHA-256", bytes))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
      const { engine, scene, picture } = window.lustro;
      const { width, height } = picture.value!;
      const shown = [];
      const alone = [];
      for (const [testid, list] of changes) {
        const canvas = document.querySelector<HTMLCanvasElement>(`[data-testid="${testid}"]`)!;
        shown.push(await digest(canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height).data));
        const changed = structuredClone(scene.value);
        for (const [path, value] of list) {
          const [table, key] = path.split(".") as [string, string | undefined];
          if (key === undefined) {
            changed[table] = value;
          } else {
            changed[table] = { ...(changed[table] as object | undefined), [key]: value };
          }
        }
        alone.push(await digest((await engine.value!.render({ scene: changed, width, height }, true)).bytes));
      }
      return { shown, alone };
    },
    [
      ["compare-left", left],
      ["compare-right", right],
    ] as [string, [string, unknown][]][],
  );
}

describe("two settings", () => {
  let lab: Lab;
  beforeAll(async () => {
    lab = await openLab({ viewport: { width: 900, height: 620 } });
    // A coarse mesh, on which all of these settings show.
    await set(lab.page, [
      ["objects[0].mesh", "primitive:sphere:12"],
      ["image.samples", 1],
      ["image.background", "#202830"],
    ]);
    await lab.page.getByTestId("compare").click();
    await lab.page.getByTestId("compare-settings").click();
  });
  afterAll(() => lab.close());

  const list = (changes: (typeof kPairs)[number]["left"]) => changes.map(([path, value]) => [pathText(path), value] as [string, unknown]);

  test.each(kPairs.map((pair) => [pair.id, pair] as const))("%s", async (id, pair) => {
    await lab.page.getByTestId(`pair-${id}`).click();
    const { shown, alone } = await sides(lab.page, list(pair.left), list(pair.right));
    expect(shown).toEqual(alone);
    expect(shown[0]).not.toBe(shown[1]);
  });

  test("one camera for both, over each other and side by side", async () => {
    const { page } = lab;
    await page.getByTestId("pair-flat-phong").click();
    const pair = kPairs.find(({ id }) => id === "flat-phong")!;
    const before = await sides(page, list(pair.left), list(pair.right));
    await page.getByTestId("layout-side").click();
    await page.getByTestId("compare-left-pane").waitFor();
    await page.keyboard.press("Escape");
    const stage = (await page.getByTestId("stage").boundingBox())!;
    await page.mouse.move(stage.x + stage.width * 0.3, stage.y + stage.height * 0.6);
    await page.mouse.down();
    await page.mouse.move(stage.x + stage.width * 0.5, stage.y + stage.height * 0.5, { steps: 5 });
    await page.mouse.up();
    await expect.poll(async () => (await sides(page, list(pair.left), list(pair.right))).shown[0]).not.toBe(before.shown[0]);
    const after = await sides(page, list(pair.left), list(pair.right));
    expect(after.shown).toEqual(after.alone);
    expect(after.shown[1]).not.toBe(before.shown[1]);
  });

  test("two settings of one's own", async () => {
    const { page } = lab;
    await page.getByTestId("compare").click();
    await page.getByTestId("compare-left-lighting").selectOption("lambert");
    await page.getByTestId("compare-right-lighting").selectOption("blinn-phong");
    await page.getByTestId("compare-left-interpolation").selectOption("gouraud");
    await page.getByTestId("compare-right-interpolation").selectOption("gouraud");
    const own = (lighting: string): [string, unknown][] => [
      ["shading.lighting", lighting],
      ["shading.interpolation", "gouraud"],
    ];
    const { shown, alone } = await sides(page, own("lambert"), own("blinn-phong"));
    expect(shown).toEqual(alone);
    expect(shown[0]).not.toBe(shown[1]);
    await page.getByTestId("compare-none").click();
    await page.getByTestId("compare-base").waitFor({ state: "detached" });
    await page.keyboard.press("Escape"); // the card of choices
  });

  test("on a narrow screen the whole card can be reached, above the sheet", async () => {
    const { page } = lab;
    const wide = page.viewportSize()!;
    await page.setViewportSize({ width: 390, height: 844 });
    await page.getByTestId("tab-lights").click();
    await page.getByTestId("compare").click();
    await page.getByTestId("compare-settings").click();
    // Playwright scrolls to what it clicks, and does not click what lies below the sheet.
    await page.getByTestId("layout-side").click();
    await page.waitForFunction(() => {
      const card = document.querySelector("#compare-card")!.getBoundingClientRect();
      const sheet = document.querySelector(".panel")!.getBoundingClientRect();
      return card.left >= 0 && card.right <= innerWidth && card.bottom <= sheet.top;
    });
    await page.getByTestId("layout-wipe").click();
    await page.getByTestId("compare-none").click();
    await page.keyboard.press("Escape");
    await page.setViewportSize(wide);
  });
});
