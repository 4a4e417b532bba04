// A scene on the page, opened by its own button, with the pictures that it names; and which of the panels' widgets were ever used.
import { encode } from "fast-png";
import type { Page } from "playwright-core";
import type { SceneDoc } from "../../src/engine/types";
import type { Bench } from "./controls";
import { optionTable, pictureMark, sceneNow, type Desk } from "./operate";
import "./window";

const kSide = 8;

/** Squares of many colours and opacities: no two ways to read it look alike. */
function checks(): Buffer {
  const data = new Uint8Array(kSide * kSide * 4);
  for (let i = 0; i < kSide * kSide; ++i) {
    const [x, y] = [i % kSide, Math.floor(i / kSide)];
    data.set([(x * 37 + y * 11) % 256, (x * 7 + y * 61 + 40) % 256, (x + y) % 2 === 0 ? 230 : 60, x < 4 ? 255 : 120], 4 * i);
  }
  return Buffer.from(encode({ width: kSide, height: kSide, data, channels: 4, depth: 8 }));
}

export async function openScene(page: Page, scene: SceneDoc, pictures: readonly string[] = []): Promise<void> {
  const before = await page.evaluateHandle(() => window.lustro.scene.value);
  await page
    .getByTestId("open-input")
    .setInputFiles([
      { name: "scene.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(scene)) },
      ...pictures.map((name) => ({ name, mimeType: "image/png", buffer: checks() })),
    ]);
  await page.waitForFunction((scene) => window.lustro.scene.value !== scene, before, { timeout: 30_000 });
}

/** Everything that is folded away, unfolded by a click. */
export async function unfold(page: Page): Promise<void> {
  const closed = page.locator(".panel-content details:not([open]) > summary");
  while ((await closed.count()) > 0) {
    await closed.first().click();
  }
}

/** From now on the page remembers which widgets were there in a part of its panels, and which of them were used. */
export async function watchWidgets(page: Page, part: string): Promise<void> {
  await page.evaluate((within) => {
    const there = new Set<string>();
    const used = new Set<string>();
    const nameOf = (widget: Element) => widget.getAttribute("data-testid") ?? widget.outerHTML.slice(0, 160);
    const panel = document.querySelector(".panel")!;
    const look = () =>
      panel.querySelectorAll(`${within} :is(input, select, button, summary)`).forEach((widget) => there.add(nameOf(widget)));
    new MutationObserver(look).observe(panel, { subtree: true, childList: true });
    look();
    for (const event of ["click", "input", "change", "keydown"]) {
      document.addEventListener(
        event,
        ({ target }) => {
          const widget = target instanceof Element ? target.closest("input, select, button, summary") : null;
          if (widget) {
            used.add(nameOf(widget));
          }
        },
        true,
      );
    }
    Object.assign(window, { unusedWidgets: () => [...there].filter((widget) => !used.has(widget)) });
  }, part);
}

export async function unusedWidgets(page: Page): Promise<string[]> {
  return page.evaluate(() => (window as unknown as { unusedWidgets: () => string[] }).unusedWidgets());
}

/** A scene opened at its panel, everything unfolded. */
export async function openBench(page: Page, { scene, tab, pictures }: Pick<Bench, "scene" | "tab" | "pictures">): Promise<Desk> {
  await openScene(page, scene, pictures);
  await page.getByTestId(`tab-${tab}`).click();
  await unfold(page);
  return { page, options: await optionTable(page), base: { scene: await sceneNow(page), picture: await pictureMark(page) } };
}
