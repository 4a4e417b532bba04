// Pictures of the page for docs/using/lab.md, into docs/pictures: wide and narrow, light and dark, each with something open.
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import type { Page } from "playwright-core";
import { test } from "vitest";
import { openLab, settled, useBrowser, type LabOptions } from "../e2e/lab";
import "../e2e/window";

useBrowser();

const kFolder = resolve(import.meta.dirname, "../../../docs/pictures");
const kPhone = { width: 390, height: 844 };

async function clickAt(page: Page, x: number, y: number): Promise<void> {
  const box = (await page.getByTestId("stage").boundingBox())!;
  await page.mouse.click(box.x + box.width * x, box.y + box.height * y);
}

const explained = (page: Page) => page.waitForSelector('[data-testid="explain-content"][data-stale="false"]');

interface Shot {
  name: string;
  options: LabOptions;
  /** what is done before the picture is taken */
  set: (page: Page) => Promise<void>;
}

const kShots: Shot[] = [
  {
    name: "lab",
    options: { colorScheme: "light" },
    set: async (page) => {
      await page.getByTestId("tab-shading").click();
    },
  },
  {
    name: "lab-explain",
    options: { colorScheme: "dark" },
    set: async (page) => {
      await clickAt(page, 0.42, 0.5);
      await explained(page);
    },
  },
  {
    name: "lab-material",
    options: { colorScheme: "dark" },
    set: async (page) => {
      await page.getByTestId("tab-material").click();
      await page.getByTestId("material-gold").click();
      await page.waitForFunction(() => document.querySelectorAll('[data-testid="library"] :is(img, canvas)').length > 20);
    },
  },
  {
    name: "lab-compare",
    options: { colorScheme: "light" },
    set: async (page) => {
      await page.getByTestId("compare").click();
      await page.getByTestId("compare-settings").click();
      await page.getByTestId("pair-flat-phong").click();
      await page.keyboard.press("Escape");
      await page.waitForSelector('[data-testid="compare-left"][data-ready="true"]');
    },
  },
  {
    name: "lab-tour",
    options: { colorScheme: "light" },
    set: async (page) => {
      await page.getByTestId("tour").click();
      await page.getByTestId("tour-lesson-lambert").click();
      await page.getByTestId("tour-card").waitFor();
    },
  },
  {
    name: "lab-narrow-light",
    options: { colorScheme: "light", viewport: kPhone, hasTouch: true },
    set: async (page) => {
      await page.getByTestId("tab-lights").click();
    },
  },
  {
    name: "lab-narrow-dark",
    options: { colorScheme: "dark", viewport: kPhone, hasTouch: true },
    set: async (page) => {
      await clickAt(page, 0.42, 0.5);
      await explained(page);
    },
  },
];

test.each(kShots.map((shot) => [shot.name, shot] as const))("%s", async (name, { options, set }) => {
  const lab = await openLab({ reducedMotion: "reduce", ...options });
  await set(lab.page);
  await settled(lab.page);
  await lab.page.screenshot({ path: `${kFolder}/${name}.jpg`, type: "jpeg", quality: 85 });
  await lab.close();
});

// What the dialog of examples shows of those that need files.
test.each(["spot", "stage", "cornell"])("the example %s", async (name) => {
  const lab = await openLab();
  const { page } = lab;
  await page.getByTestId("examples").click();
  await page.getByTestId(`example-${name}`).click();
  await page.getByTestId("examples-dialog").waitFor({ state: "detached" });
  await page.waitForFunction(() => JSON.stringify(window.lustro.scene.value).includes(".obj"), undefined, { timeout: 30_000 });
  await settled(page);
  const picture = await page.evaluate(async () => {
    const { engine, scene } = window.lustro;
    const { width, height, bytes } = await engine.value!.render({ scene: scene.value, width: 416, height: 260, samples: 8 }, true);
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = height;
    canvas.getContext("2d")!.putImageData(new ImageData(bytes, width, height), 0, 0);
    return canvas.toDataURL("image/jpeg", 0.85);
  });
  writeFileSync(
    resolve(import.meta.dirname, `../../src/files/examples/${name}.jpg`),
    Buffer.from(picture.slice(picture.indexOf(",") + 1), "base64"),
  );
  await lab.close();
});
