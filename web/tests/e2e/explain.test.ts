// Explain in the browser: from a click to the numbers, which are those of the picture; the vectors over it; the profile along a line.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { openLab, settled, useBrowser } from "./lab";

useBrowser();

/** Clicks a place of the picture, 0..1, and waits for its numbers. */
async function choose(page: Page, x: number, y: number): Promise<void> {
  const box = (await page.getByTestId("stage").boundingBox())!;
  await page.mouse.click(box.x + box.width * x, box.y + box.height * y);
  await explained(page);
}

const explained = (page: Page) => page.waitForSelector('[data-testid="explain-content"][data-stale="false"]');
const title = (page: Page) => page.getByTestId("explain").locator("h2").first().innerText();

/** What the canvas shows at the chosen pixel. */
async function shownHex(page: Page): Promise<string> {
  const [x, y] = (await title(page)).match(/\d+/g)!.map(Number) as [number, number];
  return page.getByTestId("picture").evaluate(
    (canvas: HTMLCanvasElement, [px, py]) => {
      const bytes = canvas.getContext("2d")!.getImageData(px!, py!, 1, 1).data;
      return `#${[...bytes.subarray(0, 3)].map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
    },
    [x, y],
  );
}

it("takes the clicked pixel apart, and walks on by keys; the colour is the picture's", async () => {
  const { page, close } = await openLab();
  await choose(page, 0.45, 0.55);
  expect(await page.getByTestId("explain-hex").innerText()).toBe(await shownHex(page));
  expect(await page.getByTestId("explain-sum").locator("math").count()).toBeGreaterThan(0);
  expect(await page.getByTestId("explain-light").count()).toBeGreaterThan(0);

  const [x, y] = (await title(page)).match(/\d+/g)!.map(Number) as [number, number];
  await page.getByTestId("explain-lens").focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("ArrowDown");
  await explained(page);
  expect((await title(page)).match(/\d+/g)!.map(Number)).toEqual([x - 10, y + 1]);
  await expect.poll(() => page.getByTestId("explain-hex").innerText()).toBe(await shownHex(page));
  await close();
});

it("shows one evaluation for Phong and flat, three for Gouraud", async () => {
  const { page, close } = await openLab();
  await choose(page, 0.45, 0.55);
  for (const [interpolation, count] of [
    ["gouraud", 3],
    ["flat", 1],
    ["phong", 1],
  ] as const) {
    await page.getByTestId("tab-shading").click();
    await page.getByTestId(`option-shading-interpolation-input-${interpolation}`).check({ force: true });
    await settled(page);
    await page.getByTestId("tab-explain").click();
    await explained(page);
    await expect.poll(() => page.getByTestId("explain-fragment").first().getByTestId("explain-evaluation").count()).toBe(count);
    expect(await page.getByTestId("explain-hex").innerText()).toBe(await shownHex(page));
  }
  await close();
});

it("draws the vectors in the picture, each with its switch", async () => {
  const { page, close } = await openLab();
  await choose(page, 0.45, 0.55);
  for (const name of ["N", "L", "V"]) {
    expect(await page.getByTestId(`arrow-${name}`).count()).toBe(1);
    await page.getByTestId(`draw-${name}`).click();
    expect(await page.getByTestId(`arrow-${name}`).count()).toBe(0);
  }
  expect(await page.getByTestId("explain-triangle").locator("polygon").count()).toBe(1);
  expect(await page.getByTestId("way-to-light").count()).toBeGreaterThan(0);
  await page.getByTestId("draw-triangle").click();
  await page.getByTestId("draw-lights").click();
  expect((await page.getByTestId("explain-triangle").count()) + (await page.getByTestId("way-to-light").count())).toBe(0);
  await close();
});

it("plots the light along a drawn line, for this picture and for the three interpolations", async () => {
  const { page, close } = await openLab();
  const box = (await page.getByTestId("stage").boundingBox())!;
  await page.getByTestId("line-tool").click();
  await page.mouse.move(box.x + box.width * 0.1, box.y + box.height * 0.5);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.8, box.y + box.height * 0.6, { steps: 6 });
  await page.mouse.up();
  await page.getByTestId("profile-plot").locator("canvas").waitFor();
  expect(await page.getByTestId("line-tool").getAttribute("aria-pressed")).toBe("false");
  expect(await page.getByTestId("profile-plot").getAttribute("aria-label")).toMatch(/\d/);

  const address = () => page.evaluate(() => location.hash);
  await expect.poll(address, { message: "the address follows" }).not.toBe("");
  const plain = await address();
  await page.getByTestId("profile-compare").click();
  await page.getByTestId("profile-difference").waitFor();
  const errors = (await page.getByTestId("profile-errors").locator("td").allInnerTexts()).map(Number).filter((error) => error > 0);
  expect(errors.length, "flat and Gouraud differ from Phong").toBe(4);

  const wayOf = (shown: Page) => shown.getByTestId("profile-line").locator("path").getAttribute("d");
  await expect.poll(address).not.toBe(plain);
  const other = await openLab({ hash: await address() });
  await other.page.getByTestId("tab-explain").click();
  await other.page.getByTestId("profile-difference").waitFor();
  expect(await wayOf(other.page), "the link holds the line").toBe(await wayOf(page));
  await other.close();

  await page.getByTestId("profile-plot").focus();
  await page.keyboard.press("End");
  expect(await page.locator(".x-line-cursor").count()).toBe(1);
  const before = await page.getByTestId("line-to").getAttribute("cx");
  await page.getByTestId("line-to").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await expect.poll(() => page.getByTestId("line-to").getAttribute("cx")).not.toBe(before);
  await page.getByTestId("line-remove").click();
  expect(await page.getByTestId("profile-line").count()).toBe(0);
  await close();
});

it("on a phone a tap opens the numbers, and the point stays when the sheet takes its place", async () => {
  const { page, close } = await openLab({ viewport: { width: 390, height: 780 }, hasTouch: true });
  const box = (await page.getByTestId("stage").boundingBox())!;
  await page.touchscreen.tap(box.x + box.width * 0.5, box.y + box.height * 0.55);
  await explained(page);
  await expect.poll(async () => (await page.getByTestId("explain-hex").innerText()) === (await shownHex(page))).toBe(true);
  expect(await page.getByTestId("pixel-mark").count()).toBe(1);
  await close();
});
