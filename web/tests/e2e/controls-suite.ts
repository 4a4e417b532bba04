// What the files of tests of the page's controls have in common: one page, one scene after the other, and each of its controls operated.
import { afterAll, afterEach, beforeAll, describe, expect, test } from "vitest";
import { openBench, unusedWidgets, watchWidgets } from "./bench-page";
import type { Bench } from "./controls";
import { openLab, useBrowser, type Lab } from "./lab";
import { operate, undoAll, type Desk } from "./operate";

/**
 * The page of a file of tests: call it at the top.
 * tab   where it begins
 * part  of the panels, whose widgets none may be left out
 */
export function useLab(tab: Bench["tab"], part = ".panel-content"): () => Lab {
  useBrowser();
  let lab: Lab | undefined;
  beforeAll(async () => {
    lab = await openLab({ viewport: { width: 880, height: 420 } });
    lab.page.setDefaultTimeout(10_000);
    await lab.page.getByTestId(`tab-${tab}`).click();
    await watchWidgets(lab.page, part);
  });
  afterAll(() => lab?.close());
  return () => lab!;
}

/** Call it at the end: what is in the panels of this file's tests, and what none of them has used. */
export function testThatNothingIsLeftOut(lab: () => Lab): void {
  test("no widget is left out", async () => {
    expect(await unusedWidgets(lab().page)).toEqual([]);
  });
}

export function testBenches(lab: () => Lab, benches: readonly Bench[]): void {
  describe.each(benches)("$name", (bench) => {
    let desk: Desk;
    beforeAll(async () => {
      desk = await openBench(lab().page, bench);
    });
    afterEach(async () => {
      // A scene that the engine refuses keeps its picture: that is not what `unseen` means.
      expect(await lab().page.getByTestId("message-error").allInnerTexts()).toEqual([]);
      await undoAll(desk);
    });

    test.each(bench.controls)("$key", async (control) => {
      const light = /^lights\[(\d)\]/.exec(control.path ?? "")?.[1];
      const button = lab().page.getByTestId(`light-${light}`);
      if (light !== undefined && (await button.getAttribute("aria-pressed")) !== "true") {
        await button.click();
      }
      await operate(desk, control);
    });
  });
}
