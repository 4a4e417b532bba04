// In: every format that the page opens, dropped or chosen, alone or with what belongs to it; the examples; and files that are broken, which are said
// to be so while the picture before them stays.
import { existsSync, mkdtempSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, describe, expect, test } from "vitest";
import { broken, kBin, kGlb, kGltf, kMtl, kObj, kPly, kScene, kStl, kTexture, type TestFile } from "../fixtures/models";
import { drop, dropFromDisk, hashOf, opened, said } from "./drop";
import { openLab, useBrowser, type Lab } from "./lab";
import "./window";

useBrowser();

let lab: Lab;
let page: Page;
beforeAll(async () => {
  lab = await openLab({ viewport: { width: 900, height: 600 } });
  page = lab.page;
});
afterAll(() => lab.close());

const objects = () => page.evaluate(() => window.lustro.scene.value.objects.map(({ mesh }) => mesh));
const triangles = () => page.evaluate(() => window.lustro.picture.value!.triangles);

/** How many pixels are mostly of one primary colour. */
const primaries = () =>
  page.evaluate(() => {
    const { bytes } = window.lustro.picture.value!;
    const counts = [0, 0, 0];
    for (let at = 0; at < bytes.length; at += 4) {
      for (let channel = 0; channel < 3; ++channel) {
        const others = Math.max(bytes[at + ((channel + 1) % 3)]!, bytes[at + ((channel + 2) % 3)]!);
        if (bytes[at + channel]! > 60 && bytes[at + channel]! > 2 * others) {
          counts[channel]!++;
        }
      }
    }
    return counts;
  });

/** Pixels that are not the background's. */
const covered = () => page.evaluate(() => window.lustro.picture.value!.pixelsCovered);

const choose = (files: readonly TestFile[]) =>
  page
    .getByTestId("open-input")
    .setInputFiles(files.map(({ name, bytes }) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(bytes) })));

/** name, files, triangles, whether the texture's colours are to be seen */
const kModels: [string, TestFile[], number, boolean][] = [
  ["OBJ with MTL and texture", [kTexture, kMtl, kObj], 2, true],
  ["PLY", [kPly], 6, false],
  ["STL", [kStl], 6, false],
  ["glTF with buffer and texture", [kBin, kGltf, kTexture], 2, true],
  ["GLB", [kGlb], 2, true],
  ["a scene file with its mesh", [kPly, kScene], 18, false],
];

describe("what the page opens", () => {
  // A scene of another kind, so that none of these passes by what was open before it.
  beforeEach(() =>
    opened(page, () => drop(page, [{ name: "torus.json", bytes: Buffer.from('{"objects":[{"mesh":"primitive:torus"}]}') }])),
  );

  test.each(kModels)("%s, dropped and chosen", async (_, files, count, isTextured) => {
    await opened(page, () => drop(page, files));
    expect(await triangles()).toBe(count);
    expect(await covered()).toBeGreaterThan(1000);
    expect(await said(page, "error")).toBe("");
    expect(await said(page, "warning")).toBe("");
    expect(await page.getByTestId("drop-zone").count(), "the drop zone is gone").toBe(0);
    if (isTextured) {
      for (const pixels of await primaries()) {
        expect(pixels, "red, green and blue texels are seen").toBeGreaterThan(500);
      }
    }
    const hash = await hashOf(page);
    await opened(page, () => choose(files));
    expect(await hashOf(page), "the button opens the same").toBe(hash);
  });

  test("a folder with folders in it", async () => {
    const folder = mkdtempSync(join(tmpdir(), "lustro-drop-"));
    try {
      const model = join(folder, "model");
      mkdirSync(join(model, "paint"), { recursive: true });
      writeFileSync(join(model, kObj.name), kObj.bytes);
      writeFileSync(join(model, kMtl.name), Buffer.from(kMtl.bytes).toString().replace(kTexture.name, `paint/${kTexture.name}`));
      writeFileSync(join(model, "paint", kTexture.name), kTexture.bytes);
      await opened(page, () => dropFromDisk(page, [model]));
      expect(await objects()).toEqual(["square.obj"]);
      expect(Math.min(...(await primaries()))).toBeGreaterThan(500);
      expect(await said(page, "warning")).toBe("");
    } finally {
      rmSync(folder, { recursive: true });
    }
  });

  test("a model without its texture is shown plain, and the page says what is missing", async () => {
    await opened(page, () => drop(page, [kObj, kMtl]));
    expect(await triangles()).toBe(2);
    expect(Math.max(...(await primaries()))).toBe(0);
    expect(await said(page, "warning")).toContain(kTexture.name);
    await opened(page, () => drop(page, [kObj, kMtl, kTexture]));
    expect(await said(page, "warning"), "it is no longer missing").toBe("");
  });

  test("pictures alone join the model that is open", async () => {
    await opened(page, () => drop(page, [kPly]));
    await drop(page, [kTexture]);
    await expect.poll(() => said(page, "success")).toContain(kTexture.name);
    expect(await objects()).toEqual([kPly.name]);
    expect(await said(page, "error")).toBe("");
  });

  test("a scene's text that is pasted", async () => {
    await opened(page, () =>
      page.evaluate(() => {
        const clipboardData = new DataTransfer();
        clipboardData.setData("text/plain", ' {"objects": [{"mesh": "primitive:plane"}]}');
        document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));
      }),
    );
    expect(await objects()).toEqual(["primitive:plane"]);
  });
});

const kExamples = ["start", "threeWays", "gems", "shadows", "spot", "stage", "mist", "cornell", "chessmen", "hero"];

describe("the examples", () => {
  const seen = new Set<string | undefined>();

  test("are these", async () => {
    await page.getByTestId("examples").click();
    const names = await page.locator(".example").evaluateAll((all) => all.map((one) => one.getAttribute("data-testid")));
    expect(names).toEqual(kExamples.map((name) => `example-${name}`));
    await page.getByTestId("examples-dialog-close").click();
  });

  test.each(kExamples)("%s", async (name) => {
    await opened(page, async () => {
      await page.getByTestId("examples").click();
      await page.getByTestId(`example-${name}`).click();
    });
    expect(await page.getByTestId("examples-dialog").count()).toBe(0);
    expect(await covered()).toBeGreaterThan(1000);
    expect(await said(page, "error")).toBe("");
    expect(await said(page, "warning")).toBe("");
    const hash = await hashOf(page);
    expect(seen.has(hash), "a picture of its own").toBe(false);
    seen.add(hash);
  });
});

/** name, files, what the message must say: the file and the place in it */
const kBroken: [string, TestFile[], RegExp][] = [
  ["an OBJ with an index too large", [broken.obj], /far\.obj:5.*9/],
  ["a PLY cut short", [broken.ply], /short\.ply/],
  ["a GLB cut short", [broken.glb], /short\.glb/],
  ["a scene file with a wrong key", [broken.scene], /wrong\.json.*lights\[0\]\.cutof/],
  ["a scene file that is no JSON", [broken.syntax], /comma\.json:3/],
  ["an empty model", [broken.empty], /empty\.obj/],
  ["an empty scene file", [broken.emptyScene], /empty\.json/],
  ["an unknown extension", [broken.unknown], /notes\.txt/],
  ["several unknown files", [broken.unknown, { ...broken.unknown, name: "more.txt" }], /none of these files is a model or a scene/],
  ["a scene file without its mesh", [kScene], /two\.json.*objects\[0\]\.mesh.*pyramid\.ply/],
];

describe("what is broken", () => {
  beforeAll(() => opened(page, () => drop(page, [kObj, kMtl, kTexture])));

  test.each(kBroken)("%s", async (_, files, words) => {
    const hash = await hashOf(page);
    const before = await page.evaluateHandle(() => window.lustro.picture.value);
    const scene = await page.evaluateHandle(() => window.lustro.scene.value);
    await drop(page, files);
    await expect.poll(() => said(page, "error"), { timeout: 15_000 }).toMatch(words);
    expect(await said(page, "error"), "no folder of the engine's own").not.toContain("/files/");
    expect(await page.getByTestId("message-error").count()).toBe(1);
    expect(await page.evaluate((doc) => window.lustro.scene.value === doc, scene)).toBe(true);
    expect(await page.evaluate((drawn) => window.lustro.picture.value === drawn, before), "the picture stays").toBe(true);
    expect(await hashOf(page), "the engine still has the files before").toBe(hash);
    expect(await page.getByTestId("loading").count()).toBe(0);
    await page.getByTestId("message-error").getByRole("button").click();
    expect(await page.getByTestId("message-error").count(), "the message can be dismissed").toBe(0);
  });

  test("what is whole opens again, and the message goes", async () => {
    await drop(page, [broken.obj]);
    await expect.poll(() => said(page, "error")).not.toBe("");
    await opened(page, () => drop(page, [kPly]));
    expect(await said(page, "error")).toBe("");
  });
});

const kShared = new URL("../../../../shared/assets/", import.meta.url).pathname;

/** as they are in the world: the main file, what is dropped with it, triangles */
const kWorld: [string, string[], number][] = [
  ["obj/obj2gltf/box-textured/", ["box-textured.obj", "box-textured.mtl", "cesium.png"], 12],
  ["ply/online3dviewer/", ["cube_rgb_binary.ply"], 12],
  ["stl/online3dviewer/", ["cube_meshlab_binary.stl"], 12],
  ["gltf/BoxTextured/glTF/", ["BoxTextured.gltf", "BoxTextured0.bin", "CesiumLogoFlat.png"], 12],
  ["gltf/BoxTextured/glTF-Binary/", ["BoxTextured.glb"], 12],
];

describe.skipIf(!existsSync(kShared))(existsSync(kShared) ? "models of others" : "models of others: ../shared/assets is not there", () => {
  test.each(kWorld)("%s%s", async (folder, names, count) => {
    await opened(page, () =>
      dropFromDisk(
        page,
        names.map((name) => kShared + folder + name),
      ),
    );
    expect(await triangles()).toBe(count);
    expect(await covered()).toBeGreaterThan(1000);
    expect(await said(page, "error")).toBe("");
    expect(await said(page, "warning")).toBe("");
  });
});
