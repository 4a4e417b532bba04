// Pictures of the page for docs/using/lab.md, into docs/pictures: wide and narrow, light and dark, each with something open.
import { resolve } from "node:path";
import type { Page } from "playwright-core";
import { test } from "vitest";
import { openLab, settled, useBrowser, type LabOptions } from "../e2e/lab";

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
