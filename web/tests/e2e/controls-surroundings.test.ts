// The picture, and what surrounds the objects: every control of the panels, used as a person does.
import { expect, test } from "vitest";
import { openBench } from "./bench-page";
import { kBenches } from "./controls";
import { testBenches, testThatNothingIsLeftOut, useLab } from "./controls-suite";
import { pictureMark, stated, type } from "./operate";

const lab = useLab("scene");
testBenches(lab, kBenches.surroundings);

const kParts = { fog: "table", environment: "table", shadow: "true", occlusion: "true", ground: "true" };

test("parts that are there or not", async () => {
  const { page } = lab();
  const lights = [{ type: "directional", direction: [-1, -1, -0.6] }];
  const objects = [
    { mesh: "primitive:sphere:24", material: "brass" },
    { mesh: "primitive:plane", matrix: [3, 0, 0, 0, 0, 1, 0, -1, 0, 0, 3, 0, 0, 0, 0, 1] },
  ];
  const desk = await openBench(page, { tab: "scene", scene: { image: { samples: 1 }, lights, objects } });
  for (const [part, kind] of Object.entries(kParts)) {
    await page.getByTestId(`toggle-${part}`).click();
    const value = await stated(page, part);
    expect(kind === "true" ? value : typeof value, part).toEqual(kind === "true" ? true : "object");
    expect(await pictureMark(page), `${part} is seen`).not.toBe(desk.base.picture);
    await page.getByTestId(`toggle-${part}`).press("Space");
    expect(await stated(page, part), part).toBe(undefined);
    expect(await pictureMark(page), `without ${part}`).toBe(desk.base.picture);
  }
});

test("the picture's size is the window's, or its own", async () => {
  const { page } = lab();
  const desk = await openBench(page, { tab: "scene", scene: { image: { samples: 1 }, objects: [{ mesh: "primitive:cube" }] } });
  await page.getByTestId("picture-size-input-stated").click();
  expect(`${String(await stated(page, "image.width"))}x${String(await stated(page, "image.height"))}`).toBe(
    desk.base.picture.split(" ")[0],
  );
  await type(page, "option-image-width-input", 200);
  await type(page, "option-image-height-input", 200);
  expect((await pictureMark(page)).split(" ")[0], "as large as fits").toMatch(/^(\d+)x\1$/);
  await page.getByTestId("picture-size-input-window").click();
  expect(await stated(page, "image.width")).toBe(undefined);
  expect(await stated(page, "image.height")).toBe(undefined);
  expect(await pictureMark(page)).toBe(desk.base.picture);
});

test("the sky's picture", async () => {
  const { page } = lab();
  const scene = { image: { samples: 1 }, environment: { color: [0.2, 0.22, 0.26] }, objects: [{ mesh: "primitive:sphere:24" }] };
  const desk = await openBench(page, { tab: "scene", scene, pictures: ["checks.png"] });
  await page.getByTestId("environment-file-input").selectOption("checks.png");
  expect(await stated(page, "environment.file")).toBe("checks.png");
  expect(await pictureMark(page)).not.toBe(desk.base.picture);
  await page.getByTestId("environment-file-input").selectOption("");
  expect(await stated(page, "environment.file")).toBe(undefined);
  expect(await pictureMark(page)).toBe(desk.base.picture);
});

testThatNothingIsLeftOut(lab);
