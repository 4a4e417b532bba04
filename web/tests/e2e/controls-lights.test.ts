// The lights: every control of the panels, used as a person does.
import { expect, test } from "vitest";
import { openBench } from "./bench-page";
import { kBenches } from "./controls";
import { testBenches, testThatNothingIsLeftOut, useLab } from "./controls-suite";
import { pictureMark, stated, type, undoAll } from "./operate";

const lab = useLab("lights");
testBenches(lab, kBenches.lights);

const list = async () => (await stated(lab().page, "lights")) as Record<string, unknown>[] | undefined;

test("the default lights are taken over, and come back", async () => {
  const { page } = lab();
  const desk = await openBench(page, { tab: "lights", scene: { image: { samples: 1 }, objects: [{ mesh: "primitive:sphere:24" }] } });
  expect(await page.getByTestId("light-handle-0").count(), "they have no handles").toBe(0);
  await page.getByTestId("rig-take").click();
  expect((await list())?.length).toBeGreaterThan(1);
  expect(await pictureMark(page), "nothing changes to the eye").toBe(desk.base.picture);
  await page.getByTestId("rig-back").click();
  expect(await list()).toBe(undefined);
});

test("lights are added, copied and removed", async () => {
  const { page } = lab();
  const desk = await openBench(page, {
    tab: "lights",
    scene: { image: { samples: 1 }, lights: [], objects: [{ mesh: "primitive:sphere:24" }] },
  });
  for (const { word } of desk.options.get("lights[].type")!.words) {
    await page.getByTestId("light-add").click();
    await page.getByTestId(`light-add-${word}`).click();
    expect((await list())?.map((light) => light["type"])).toEqual([word]);
    const lit = await pictureMark(page);
    expect(lit, `a new ${word} light shines on what is seen`).not.toBe(desk.base.picture);

    if (word === "point") {
      await page.getByTestId("light-copy").click();
      expect((await list())?.length).toBe(2);
      expect(await pictureMark(page), "two of them are brighter").not.toBe(lit);
      await page.getByTestId("light-remove").click();
      expect(await pictureMark(page)).toBe(lit);
    }
    await page.getByTestId("light-remove").click();
    expect(await list()).toEqual([]);
  }
  await undoAll(desk);
});

test("a light is chosen, made brighter, and fixed to the camera", async () => {
  const { page } = lab();
  const scene = {
    image: { samples: 1 },
    camera: { eye: [0, 1, 8], target: [0, 0, 0] },
    lights: [
      { type: "point", position: [3, 3, 3], diffuse: [0.4, 0.2, 0.1], specular: [0.4, 0.4, 0.4] },
      { type: "directional", direction: [0, -1, 0] },
    ],
    objects: [{ mesh: "primitive:sphere:24" }],
  };
  const desk = await openBench(page, { tab: "lights", scene });
  await page.getByTestId("light-1").click();
  await page.getByTestId("light-0").click();
  await type(page, "light-brightness-input", 0.8);
  expect((await list())![0]!["diffuse"]).toEqual([0.8, 0.4, 0.2]);
  expect((await list())![0]!["specular"]).toEqual([0.8, 0.8, 0.8]);
  const bright = await pictureMark(page);
  expect(bright).not.toBe(desk.base.picture);
  await page.getByTestId("light-brightness-slider").press("PageUp");
  expect(await pictureMark(page)).not.toBe(bright);

  await page.getByTestId("light-fixed-input-camera").click();
  await page.getByTestId("stage").press("ArrowLeft");
  await expect.poll(async () => (await list())![0]!["position"], { message: "it follows the camera" }).not.toEqual([3, 3, 3]);
  expect((await list())![1]!["direction"], "the other one does not").toEqual([0, -1, 0]);
  const carried = (await list())![0]!["position"];
  await page.getByTestId("light-fixed-input-world").click();
  await page.getByTestId("stage").press("ArrowLeft");
  expect((await list())![0]!["position"], "it stays").toEqual(carried);
  await pictureMark(page);
  await undoAll(desk);
});

testThatNothingIsLeftOut(lab);
