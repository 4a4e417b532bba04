// How surfaces are lit, and from where they are seen: every control of the panels, used as a person does.
import { expect, test } from "vitest";
import { openBench } from "./bench-page";
import { kBenches } from "./controls";
import { testBenches, testThatNothingIsLeftOut, useLab } from "./controls-suite";
import { pictureMark, stated, type, undoAll } from "./operate";

const lab = useLab("shading");
testBenches(lab, kBenches.shading);

test("the views", async () => {
  const { page } = lab();
  const scene = { image: { samples: 1 }, objects: [{ mesh: "primitive:teapot", material: "brass" }] };
  const desk = await openBench(page, { tab: "camera", scene });
  const looks = new Set<string>();
  for (const { word } of desk.options.get("camera.view")!.words) {
    await page.getByTestId(`view-${word}`).click();
    expect(await stated(page, "camera.view")).toBe(word);
    expect(await page.getByTestId(`view-${word}`).getAttribute("aria-pressed")).toBe("true");
    looks.add(await pictureMark(page));
  }
  expect(looks.size, "each looks from elsewhere").toBe(desk.options.get("camera.view")!.words.length);

  await type(page, "option-camera-eye-input-x", 30);
  const far = await pictureMark(page);
  await page.getByTestId("camera-frame").click();
  expect(((await stated(page, "camera.eye")) as number[])[0], "it comes nearer").toBeLessThan(25);
  expect(await pictureMark(page)).not.toBe(far);
  await undoAll(desk);
});

testThatNothingIsLeftOut(lab);
