// Out: the picture, the scene file, the command, the shaders and the link are what they promise, checked with the command itself where it is built.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { decode } from "fast-png";
import type { Download, Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { kMtl, kObj, kPly, kScene, kTexture, type TestFile } from "../fixtures/models";
import { drop, hashOf, opened, said } from "./drop";
import { openLab, settled, useBrowser, type Lab } from "./lab";
import "./window";

useBrowser();

const kRoot = fileURLToPath(new URL("../../../", import.meta.url));
const kCommand = process.env["LUSTRO"] ?? `${kRoot}build/release/app/lustro`;
const hasCommand = existsSync(kCommand);
const kViewport = { width: 900, height: 600 };

let lab: Lab;
let page: Page;
let folder: string;
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "lustro-export-"));
  lab = await openLab({ viewport: kViewport });
  page = lab.page;
});
afterAll(async () => {
  rmSync(folder, { recursive: true });
  await lab.close();
});

async function bytesOf(download: Download): Promise<Buffer> {
  const parts: Buffer[] = [];
  for await (const part of await download.createReadStream()) {
    parts.push(part as Buffer);
  }
  return Buffer.concat(parts);
}

/** What a button of the dialog saves. */
async function saved(testid: string): Promise<{ name: string; bytes: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(testid).click()]);
  return { name: download.suggestedFilename(), bytes: await bytesOf(download) };
}

interface Exported {
  png: Buffer;
  hash: string;
  command: string;
  scene: { name: string; bytes: Buffer };
}

const textOf = (testid: string) => page.getByTestId(testid).innerText();

async function fill(testid: string, value: number): Promise<void> {
  await page.getByTestId(testid).fill(String(value));
  await page.getByTestId(testid).press("Enter");
}

/** All of it through the dialog, for a picture of a stated size. */
async function exported(width: number, height: number, samples: number): Promise<Exported> {
  await page.getByTestId("export").click();
  await fill("export-width", width);
  await fill("export-height", height);
  await page.getByTestId(`export-samples-${samples}`).check({ force: true });
  const [png, scene] = [await saved("export-png"), await saved("export-scene-save")];
  await page.getByTestId("export-hash").click();
  await page
    .getByTestId("export-hash-value")
    .filter({ hasText: /^[0-9a-f]{16}$/ })
    .waitFor();
  const [hash, command] = [await textOf("export-hash-value"), await textOf("export-command-text")];
  await page.getByTestId("export-dialog-close").click();
  expect(png.name).toMatch(/^\w+\.png$/);
  return { png: png.bytes, hash, command, scene };
}

/** Width, height, and RGBA, however the file stores them. */
function pixels(png: Uint8Array): { width: number; height: number; rgba: Buffer } {
  const { width, height, data, channels, depth } = decode(png);
  expect(depth).toBe(8);
  const rgba = Buffer.alloc(width * height * 4, 255);
  for (let at = 0; at < width * height; ++at) {
    for (let channel = 0; channel < 4; ++channel) {
      const source = channels >= 3 ? channel : channel < 3 ? 0 : 1;
      if (source < channels) {
        rgba[at * 4 + channel] = data[at * channels + source]!;
      }
    }
  }
  return { width, height, rgba };
}

function expectSamePixels(page: Uint8Array, native: Uint8Array): void {
  const [ours, theirs] = [pixels(page), pixels(native)];
  expect([ours.width, ours.height]).toEqual([theirs.width, theirs.height]);
  let differ = 0;
  for (let at = 0; at < ours.rgba.length; at += 4) {
    differ += ours.rgba.readUInt32LE(at) === theirs.rgba.readUInt32LE(at) ? 0 : 1;
  }
  expect(differ, "pixels that differ").toBe(0);
  expect(new Set(new Uint32Array(Uint8Array.from(ours.rgba).buffer)).size, "it is a picture of something").toBeGreaterThan(20);
}

/** A line of a shell, where the files are. */
function shell(line: string): string {
  const path = `${dirname(kCommand)}${delimiter}${process.env["PATH"] ?? ""}`;
  return execFileSync("/bin/sh", ["-c", line], { cwd: folder, env: { ...process.env, PATH: path }, encoding: "utf8" });
}

interface Case {
  files: TestFile[];
  /** made on the page after the files are open */
  change?: [string, unknown][];
  /** what the command draws from */
  source: string;
}

const kTurned: [string, unknown] = ["camera", { eye: [2, 1.5, 3], target: [0, 0, 0.2], fov: 40 }];

const kCases: Record<string, Case> = {
  "a shape and flags alone": {
    files: [{ name: "shape.json", bytes: Buffer.from('{"objects":[{"mesh":"primitive:torus"}]}') }],
    change: [
      ["shading.interpolation", "gouraud"],
      ["camera.fov", 30],
      ["image.background", "#203040"],
    ],
    source: "shape.json",
  },
  "a model with a texture, seen from elsewhere": { files: [kObj, kMtl, kTexture], change: [kTurned], source: "square.obj" },
  "a scene that flags cannot say": {
    files: [kPly, kScene],
    change: [kTurned, ["objects[1].material", { diffuse: [0.1, 0.5, 0.9], shininess: 12 }], ["image.background", [0, 0, 0, 0]]],
    source: "scene.json",
  },
};

describe.each(Object.entries(kCases))("%s", (_, { files, change = [], source }) => {
  let out: Exported;
  beforeAll(async () => {
    await opened(page, () => drop(page, files));
    for (const [path, value] of change) {
      await page.evaluate(([place, stated]) => window.lustro.update(place, stated), [path, value] as const);
    }
    await settled(page);
    out = await exported(321, 203, 2);
    for (const { name, bytes } of files) {
      writeFileSync(join(folder, name), bytes);
    }
  });

  test("the exported scene opens again as what it was", async () => {
    const before = await hashOf(page, 2);
    const others = files.filter(({ name }) => !name.endsWith(".json"));
    const text = out.scene.bytes.toString();
    expect(text).toBe(out.command.includes(" scene.json ") ? text : await sceneFile());
    await opened(page, () => drop(page, [...others, { name: "again.json", bytes: out.scene.bytes }]));
    expect(await said(page, "error")).toBe("");
    expect(await hashOf(page, 2)).toBe(before);
    expect(JSON.parse(await sceneFile())).toEqual(JSON.parse(text));
  });

  const what = hasCommand ? "" : " (skipped: the command is not built)";
  test.skipIf(!hasCommand)(`the PNG is the command's picture of the exported scene, pixel for pixel${what}`, () => {
    writeFileSync(join(folder, "exported.json"), out.scene.bytes);
    shell("lustro render --quiet exported.json --width 321 --height 203 --samples 2 -o native.png");
    expectSamePixels(out.png, readFileSync(join(folder, "native.png")));
  });

  test.skipIf(!hasCommand)(`the offered command, as it stands, draws this picture${what}`, () => {
    expect(out.command).toContain(`lustro render ${source === "shape.json" ? "" : source}`);
    if (source === "scene.json") {
      expect(out.scene.name).toBe("scene.json");
      writeFileSync(join(folder, "scene.json"), out.scene.bytes);
    }
    shell(`${out.command} --quiet`);
    expectSamePixels(out.png, readFileSync(join(folder, "picture.png")));
    const hashed = shell(out.command.replace("lustro render", "lustro hash").replace(/ -o \S+$/, ""));
    expect(hashed.trim().split(/\s/)[0]).toBe(out.hash);
  });
});

const sceneFile = () => page.evaluate(() => window.lustro.engine.value!.sceneFile(window.lustro.scene.value));

describe("the shaders", () => {
  test("of every setting compile and fit together", async () => {
    const made = await page.evaluate(async () => {
      const { engine, scene } = window.lustro;
      const options = (await engine.value!.options()).find(({ path }) => path === "shading")!.options;
      const wordsOf = (key: string) => options.find((option) => option.key === key)!.words.map(({ word }) => word);
      const gl = document.createElement("canvas").getContext("webgl2")!;
      const problems: string[] = [];
      let count = 0;
      for (const lighting of wordsOf("lighting")) {
        for (const interpolation of wordsOf("interpolation")) {
          const glsl = await engine.value!.glsl({ ...scene.value, shading: { lighting, interpolation } });
          const program = gl.createProgram();
          for (const [kind, text] of [
            [gl.VERTEX_SHADER, glsl.vertex],
            [gl.FRAGMENT_SHADER, glsl.fragment],
          ] as const) {
            const shader = gl.createShader(kind)!;
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
              problems.push(`${lighting} ${interpolation}: ${gl.getShaderInfoLog(shader)}`);
            }
            gl.attachShader(program, shader);
          }
          gl.linkProgram(program);
          if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
            problems.push(`${lighting} ${interpolation}: ${gl.getProgramInfoLog(program)}`);
          }
          gl.deleteProgram(program);
          count++;
        }
      }
      return { problems, count };
    });
    expect(made.problems).toEqual([]);
    expect(made.count).toBeGreaterThanOrEqual(9);
  });

  test("in the dialog are the current setting's", async () => {
    const asked = await page.evaluate(() => window.lustro.engine.value!.glsl(window.lustro.scene.value));
    await page.getByTestId("export").click();
    await expect.poll(() => page.getByTestId("export-fragment-text").textContent()).toBe(asked.fragment);
    const [vertex, fragment] = [await saved("export-vertex-save"), await saved("export-fragment-save")];
    await page.getByTestId("export-dialog-close").click();
    expect(vertex.name).toMatch(/\.vert$/);
    expect(fragment.name).toMatch(/\.frag$/);
    expect(vertex.bytes.toString()).toBe(asked.vertex);
    expect(fragment.bytes.toString()).toBe(asked.fragment);
  });
});

test("a picture that the engine refuses is said to be so in the dialog", async () => {
  await page.evaluate(() => window.lustro.update("camera.fov", 900));
  await page.getByTestId("export").click();
  await page.getByTestId("export-png").click();
  await expect.poll(() => page.getByTestId("export-problem").allInnerTexts()).toEqual([expect.stringContaining("camera.fov")]);
  await page.getByTestId("export-dialog-close").click();
  await page.evaluate(() => window.lustro.update("camera.fov", 40));
  await expect.poll(() => said(page, "error"), { message: "the cause is gone" }).toBe("");
});

/** What the dialog "Share" offers. */
async function link(): Promise<string> {
  await page.getByTestId("share").click();
  const url = await page.getByTestId("share-link").inputValue();
  await page.getByTestId("share-dialog-close").click();
  return new URL(url).hash;
}

/** What a page shows, as its reader sees it. */
async function sightOf(shown: Page): Promise<object> {
  const title = shown.getByTestId("explain").locator("h2").first();
  await shown.waitForSelector('[data-testid="explain-content"][data-stale="false"]');
  return {
    scene: await shown.evaluate(() => window.lustro.engine.value!.sceneFile(window.lustro.scene.value)),
    hash: await hashOf(shown),
    left: await shown.getByTestId("split-left-label").innerText(),
    right: await shown.getByTestId("split-right-label").innerText(),
    wipe: await shown.getByTestId("wipe").getAttribute("aria-valuenow"),
    pixel: await title.innerText(),
    color: await shown.getByTestId("explain-hex").innerText(),
  };
}

describe("the link", () => {
  test("restores the scene, the comparison and the chosen pixel", async () => {
    await opened(page, async () => {
      await page.getByTestId("examples").click();
      await page.getByTestId("example-gems").click();
    });
    await page.evaluate(() => window.lustro.update("shading.normals", "slerp"));
    await page.getByTestId("compare").click();
    await page.getByTestId("compare-settings").click();
    await page.getByTestId("pair-flat-phong").click();
    await page.getByTestId("compare").click();
    await page.getByTestId("wipe").press("ArrowLeft");
    await settled(page);
    await page.getByTestId("stage").press("Enter");
    await page.getByTestId("explain-lens").press("Shift+ArrowLeft");
    const sight = await sightOf(page);
    expect(sight).toMatchObject({ left: "flat", right: "phong", wipe: "48" });

    const hash = await link();
    await expect.poll(() => page.evaluate(() => location.hash), { message: "the address follows" }).toBe(hash);
    const other = await openLab({ hash, viewport: kViewport });
    expect(await sightOf(other.page)).toEqual(sight);
    await other.page.getByTestId("compare").click();
    expect(await other.page.getByTestId("pair-flat-phong").getAttribute("aria-pressed")).toBe("true");
    await other.close();
  });

  test("whose files are elsewhere asks for them by name, and restores once they are dropped", async () => {
    await opened(page, () => drop(page, [kObj, kMtl, kTexture]));
    await page.evaluate(() => window.lustro.update("shading.interpolation", "flat"));
    const [hash, drawn] = [await link(), await hashOf(page)];
    const other = await openLab({ hash, viewport: kViewport });
    await expect.poll(() => said(other.page, "note")).toContain(kObj.name);
    await opened(other.page, () => drop(other.page, [kTexture, kMtl, kObj]));
    expect(await said(other.page, "note")).toBe("");
    expect(await other.page.evaluate(() => window.lustro.scene.value.shading)).toMatchObject({ interpolation: "flat" });
    expect(await hashOf(other.page)).toBe(drawn);
    await other.close();
  });

  test("that is damaged is said to be so, and the page starts all the same", async () => {
    const hash = await link();
    const other = await openLab({ hash: hash.slice(0, -9), viewport: kViewport });
    expect(await said(other.page, "error")).toContain("damaged");
    expect(await other.page.evaluate(() => window.lustro.scene.value.objects[0]!.mesh)).toMatch(/^primitive:/);
    await other.close();
  });
});
