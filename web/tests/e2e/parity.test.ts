// The page's engine draws what the command draws, bit for bit: the same scene file has the same hash (the picture before it is stored, as
// `lustro hash` prints it).
import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { openLab, useBrowser, type Lab } from "./lab";
import "./window";

useBrowser();

const kRoot = fileURLToPath(new URL("../../../", import.meta.url));
const kCommand = process.env["LUSTRO"] ?? `${kRoot}build/release/app/lustro`;
const kShared = `${kRoot}../shared/assets/`;
const kSize = { width: 400, height: 300 };

/** Scenes that need no files but themselves: opened by the page's own button. */
const kScenes = ["chessmen", "gems", "hero", "mirrors", "mist", "room", "truth_room"];

/** Models with textures in their own folder: opened by the page's button, too. */
const kModels: [string, ...string[]][] = [
  ["gltf/Duck/glTF-Binary/Duck.glb"],
  ["gltf/CesiumMilkTruck/glTF-Binary/CesiumMilkTruck.glb"],
  ["obj/obj2gltf/box-textured/box-textured.obj", "box-textured.mtl", "cesium.png"],
];

/** Scenes whose files lie in other folders, which a file chooser does not tell: given to the engine with their paths. */
const kTrees: [string, ...string[]][] = [
  ["examples/scenes/first_light.json", "assets/spot/spot_triangulated.obj"],
  ["examples/scenes/product.json", "assets/utah_teapot/utah_teapot.obj"],
  ["examples/scenes/cornell.json", "assets/cornell_box/CornellBox-Original.obj", "assets/cornell_box/CornellBox-Original.mtl"],
];

function nativeHash(file: string): string {
  const text = execFileSync(kCommand, ["hash", file, "--width", String(kSize.width), "--height", String(kSize.height)], {
    encoding: "utf8",
  });
  return /^[0-9a-f]{16}/.exec(text)![0];
}

async function pageHash(page: Page): Promise<string | undefined> {
  return page.evaluate(async (size) => {
    const { engine, scene } = window.lustro;
    return (await engine.value!.render({ scene: scene.value, ...size, hash: true }, true)).hash;
  }, kSize);
}

/** Of the first file, given to the engine with all of them. */
async function treeHash(page: Page, root: string, paths: readonly string[]): Promise<string | undefined> {
  const files = paths.map((path) => ({ path, text: readFileSync(root + path).toString("latin1") }));
  return page.evaluate(
    async ([list, size]) => {
      const engine = window.lustro.engine.value!;
      const bytes = list.map(({ path, text }) => ({ path, bytes: Uint8Array.from(text, (letter) => letter.charCodeAt(0)) }));
      const { scene } = await engine.open(bytes, list[0]!.path);
      return (await engine.render({ scene, ...size, hash: true }, true)).hash;
    },
    [files, kSize] as const,
  );
}

/** By the page's button. */
async function openByHand(page: Page, files: readonly string[]): Promise<void> {
  const before = await page.evaluateHandle(() => window.lustro.scene.value);
  await page.getByTestId("open-input").setInputFiles([...files]);
  await page.waitForFunction((scene) => window.lustro.scene.value !== scene, before, { timeout: 30_000 });
}

describe("equal hashes", () => {
  let lab: Lab;
  beforeAll(async () => {
    if (!existsSync(kCommand)) {
      throw new Error(`there is no ${kCommand}: cmake --build build/release --target lustro_command`);
    }
    lab = await openLab();
  });
  afterAll(() => lab.close());

  test.each(kScenes)("%s", async (name) => {
    const file = `${kRoot}examples/scenes/${name}.json`;
    await openByHand(lab.page, [file]);
    expect(await pageHash(lab.page)).toBe(nativeHash(file));
  });

  test.each(kTrees)("%s", async (entry, ...others) => {
    expect(await treeHash(lab.page, kRoot, [entry, ...others])).toBe(nativeHash(kRoot + entry));
  });

  describe.skipIf(!existsSync(kShared))("models with textures", () => {
    test.each(kModels)("%s", async (entry, ...others) => {
      const folder = kShared + entry.slice(0, -basename(entry).length);
      await openByHand(lab.page, [kShared + entry, ...others.map((name) => folder + name)]);
      expect(await pageHash(lab.page)).toBe(nativeHash(kShared + entry));
    });
  });

  test.skipIf(!existsSync(kShared))("a model with JPEG textures in a folder of their own", async () => {
    const pictures = readdirSync(`${kShared}obj/armchair/textures`).map((name) => `textures/${name}`);
    const files = ["armchair.obj", "armchair.mtl", ...pictures];
    expect(await treeHash(lab.page, `${kShared}obj/armchair/`, files)).toBe(nativeHash(`${kShared}obj/armchair/armchair.obj`));
  });

  test("another scene has another hash", async () => {
    await openByHand(lab.page, [`${kRoot}examples/scenes/${kScenes[0]}.json`]);
    const before = await pageHash(lab.page);
    await lab.page.evaluate(() => window.lustro.update("shading.interpolation", "flat"));
    expect(await pageHash(lab.page)).not.toBe(before);
  });
});
