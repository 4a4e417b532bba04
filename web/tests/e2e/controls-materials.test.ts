// Materials and objects: every control of the panels, used as a person does.
import { expect, test } from "vitest";
import { openBench } from "./bench-page";
import { kBenches } from "./controls";
import { testBenches, testThatNothingIsLeftOut, useLab } from "./controls-suite";
import { pictureMark, stated, type, undoAll } from "./operate";

const lab = useLab("material");
testBenches(lab, kBenches.materials);

const scene = { image: { samples: 1 }, objects: [{ mesh: "primitive:sphere:24", material: "brass" }] };
const material = () => stated(lab().page, "objects[0].material");

test("the library's materials", async () => {
  const { page } = lab();
  const desk = await openBench(page, { tab: "material", scene });
  const balls = page.getByTestId("library").getByRole("button");
  expect(await balls.count()).toBe(29);
  for (const ball of await balls.all()) {
    await ball.click();
    expect(`material-${String(await material())}`).toBe(await ball.getAttribute("data-testid"));
  }
  await page.getByTestId("material-jade").click();
  expect(await pictureMark(page)).not.toBe(desk.base.picture);
  await type(page, "option-materials-x-shininess-input", 7);
  expect(await material(), "a change states all of it").toMatchObject({
    shininess: 7,
    diffuse: expect.anything(),
    specular: expect.anything(),
  });
  await page.getByTestId("material-own").click();
  expect(await material()).toBe(undefined);
});

test("a material of the scene is changed where it stands", async () => {
  const { page } = lab();
  const objects = [{ mesh: "primitive:sphere:24", material: "mine" }];
  const desk = await openBench(page, {
    tab: "material",
    scene: { image: { samples: 1 }, materials: { mine: { diffuse: "#cc3300" } }, objects },
  });
  await type(page, "option-materials-x-diffuse-input-text", "#0033cc");
  expect(await stated(page, "materials")).toEqual({ mine: { diffuse: "#0033cc" } });
  expect(await material()).toBe("mine");
  expect(await pictureMark(page)).not.toBe(desk.base.picture);
});

test("objects are added, copied, shaped and removed", async () => {
  const { page } = lab();
  const desk = await openBench(page, { tab: "material", scene });
  const count = async () => ((await stated(page, "objects")) as unknown[]).length;
  for (const shape of ["sphere", "torus", "cube", "plane", "teapot"]) {
    await page.getByTestId("object-add").click();
    await page.getByTestId(`object-add-${shape}`).click();
    expect(await stated(page, "objects[1].mesh")).toBe(`primitive:${shape}`);
    expect(await pictureMark(page), `the ${shape} is seen`).not.toBe(desk.base.picture);
    await page.getByTestId("object-copy").click();
    expect(await count()).toBe(3);
    await page.getByTestId("object-2").click();
    await page.getByTestId("object-remove").click();
    await page.getByTestId("object-1").click();
    await page.getByTestId("object-remove").click();
    expect(await count()).toBe(1);
  }
  expect(await pictureMark(page)).toBe(desk.base.picture);

  await page.getByTestId("object-0").click();
  await page.getByTestId("object-shape-input").selectOption("torus");
  expect(await stated(page, "objects[0].mesh"), "as coarse as before").toBe("primitive:torus:24");
  await type(page, "object-segments-input", 5);
  expect(await stated(page, "objects[0].mesh")).toBe("primitive:torus:5");
  const coarse = await pictureMark(page);
  await page.getByTestId("object-segments-slider").press("ArrowRight");
  expect(await stated(page, "objects[0].mesh"), "the next finer one").toBe("primitive:torus:6");
  await page.getByTestId("object-segments-slider").press("End");
  expect(await stated(page, "objects[0].mesh")).toBe("primitive:torus:256");
  expect(await pictureMark(page), "finer").not.toBe(coarse);
  await undoAll(desk);
});

test("an object is moved and grows", async () => {
  const { page } = lab();
  const camera = { eye: [0, 1, 8], target: [0, 0, 0] };
  const desk = await openBench(page, { tab: "material", scene: { ...scene, camera } });
  for (const [i, axis] of ["x", "y", "z"].entries()) {
    await type(page, `object-position-input-${axis}`, 0.5 + i);
  }
  expect(await stated(page, "objects[0].matrix")).toEqual([1, 0, 0, 0.5, 0, 1, 0, 1.5, 0, 0, 1, 2.5, 0, 0, 0, 1]);
  await type(page, "object-size-input", 0.5);
  expect(await stated(page, "objects[0].matrix")).toEqual([0.5, 0, 0, 0.5, 0, 0.5, 0, 1.5, 0, 0, 0.5, 2.5, 0, 0, 0, 1]);
  const small = await pictureMark(page);
  expect(small).not.toBe(desk.base.picture);
  await page.getByTestId("object-size-slider").press("PageUp");
  expect(await pictureMark(page)).not.toBe(small);
  await undoAll(desk);
});

testThatNothingIsLeftOut(lab);
