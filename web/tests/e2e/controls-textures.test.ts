// Textures: every control of the panels, used as a person does.
import { expect, test } from "vitest";
import { openBench } from "./bench-page";
import { kBenches } from "./controls";
import { testBenches, testThatNothingIsLeftOut, useLab } from "./controls-suite";
import { pictureMark, stated } from "./operate";

const lab = useLab("material", "[data-testid=textures]");
testBenches(lab, kBenches.textures);

const kScene = {
  image: { samples: 1 },
  shading: { lighting: "phong" },
  objects: [
    {
      mesh: "primitive:sphere:24",
      material: { ambient: [0.5, 0.5, 0.5], diffuse: [0.6, 0.6, 0.6], specular: [0.6, 0.6, 0.6], emission: [0.2, 0.2, 0.2], shininess: 30 },
    },
  ],
};
const kPictures = ["checks.png", "other.png"];
const kTextures = "objects[0].material.textures";

test("what pictures drive", async () => {
  const { page } = lab();
  const desk = await openBench(page, { tab: "material", scene: kScene, pictures: kPictures });
  const looks = new Map<string, string>();
  const title = page.getByTestId("textures").locator("> summary");
  await title.click();
  expect(await page.getByTestId("texture-diffuse-input").isVisible()).toBe(false);
  await title.press("Enter");
  for (const map of ["ambient", "diffuse", "specular", "emission", "shininess", "opacity", "decal", "bump", "normal", "displacement"]) {
    await page.getByTestId(`texture-${map}-input`).selectOption("checks.png");
    expect(await stated(page, kTextures)).toEqual({ [map]: "checks.png" });
    looks.set(await pictureMark(page), map);
    await page.getByTestId(`texture-${map}-input`).selectOption("");
    expect(await stated(page, kTextures), "no empty table is left").toBe(undefined);
  }
  expect(await pictureMark(page)).toBe(desk.base.picture);
  expect(looks.size, "each is something else").toBe(10);
  expect(looks.has(desk.base.picture)).toBe(false);
});

test("a picture is exchanged, the rest of its texture stays", async () => {
  const { page } = lab();
  const textures = { diffuse: { file: "checks.png", scale: [2, 2] } };
  await openBench(page, {
    tab: "material",
    scene: { objects: [{ mesh: "primitive:plane", material: { textures } }] },
    pictures: kPictures,
  });
  await page.getByTestId("texture-diffuse-input").selectOption("other.png");
  expect(await stated(page, kTextures)).toEqual({ diffuse: { file: "other.png", scale: [2, 2] } });
});

test("what a surface mirrors", async () => {
  const { page } = lab();
  const desk = await openBench(page, { tab: "material", scene: kScene, pictures: kPictures });
  const reflection = () => stated(page, `${kTextures}.reflection`);
  const choose = (id: string, picture: string) => page.getByTestId(`texture-reflection${id}-input`).selectOption(picture);
  const shape = (word: string) =>
    page.locator("label", { has: page.getByTestId(`option-materials-x-textures-reflection-shape-input-${word}`) });
  await choose("", "checks.png");
  expect(await reflection()).toBe("checks.png");
  const sphere = await pictureMark(page);
  expect(sphere).not.toBe(desk.base.picture);

  await shape("cube").click();
  const sides = ["right", "left", "top", "bottom", "front", "back"];
  expect(await reflection()).toEqual({ shape: "cube", ...Object.fromEntries(sides.map((side) => [side, "checks.png"])) });
  expect(await pictureMark(page)).not.toBe(sphere);
  for (const side of sides) {
    await choose(`-${side}`, "other.png");
    expect(await stated(page, `${kTextures}.reflection.${side}`)).toBe("other.png");
  }
  expect(await page.getByTestId("message-error").count()).toBe(0);

  await page.getByTestId("option-materials-x-textures-reflection-shape-reset").click();
  expect(await reflection()).toBe("other.png");
  await shape("cube").click();
  await shape("sphere").click();
  await choose("", "checks.png");
  expect(await pictureMark(page)).toBe(sphere);
  await choose("", "");
  expect(await stated(page, kTextures)).toBe(undefined);
});

testThatNothingIsLeftOut(lab);
