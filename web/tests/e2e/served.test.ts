// The page as `lustro lab FILE` serves it: the file is open, the page follows it on disk, and no foreign name leads to the server.
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { broken, kMtl, kObj, kTexture } from "../fixtures/models";
import { hashOf, said } from "./drop";
import { openLab, settled, useBrowser, type Lab } from "./lab";
import { kDist } from "./server";
import "./window";

useBrowser();

const kRoot = fileURLToPath(new URL("../../../", import.meta.url));
const kCommand = process.env["LUSTRO"] ?? `${kRoot}build/release/app/lustro`;
const hasCommand = existsSync(kCommand);

const kScene = { objects: [{ mesh: "square.obj" }], shading: { lighting: "lambert" } };

let folder: string;
let server: ChildProcess;
let url: string;
let lab: Lab;

const write = (name: string, content: string | Uint8Array) => writeFileSync(join(folder, name), content);

/** The server's answer to a request with headers of one's own. */
function statusOf(path: string, headers: Record<string, string> = {}, method = "GET"): Promise<number> {
  return new Promise((resolve, reject) => {
    request(new URL(path, url), { headers, method }, (answer) => {
      answer.resume();
      resolve(answer.statusCode ?? 0);
    })
      .on("error", reject)
      .end();
  });
}

describe.skipIf(!hasCommand)(`lustro lab${hasCommand ? "" : " (skipped: the command is not built)"}`, () => {
  beforeAll(async () => {
    folder = mkdtempSync(join(tmpdir(), "lustro-lab-"));
    for (const { name, bytes } of [kObj, kMtl, kTexture]) {
      write(name, bytes);
    }
    write("scene.json", JSON.stringify(kScene));
    server = spawn(kCommand, ["lab", join(folder, "scene.json"), "--no-open", "--port", "0", "--json", "--page", kDist], {
      stdio: ["ignore", "pipe", "inherit"],
    });
    const line = await new Promise<string>((resolve, reject) => {
      createInterface(server.stdout!).once("line", resolve);
      server.once("exit", (code) => reject(new Error(`lustro lab ended: ${code}`)));
    });
    url = (JSON.parse(line) as { url: string }).url;
    lab = await openLab({ url, viewport: { width: 900, height: 600 } });
    await lab.page.waitForFunction(() => window.lustro.scene.value.objects[0]?.mesh === "square.obj");
    await settled(lab.page);
  });
  afterAll(async () => {
    await lab?.close();
    server?.kill();
    rmSync(folder, { recursive: true });
  });

  test("the file is open, with all that it names, on a page that is isolated", async () => {
    const { page } = lab;
    expect(await page.evaluate(() => [window.lustro.picture.value!.triangles, crossOriginIsolated])).toEqual([2, true]);
    expect(await page.evaluate(() => window.lustro.scene.value.shading)).toMatchObject({ lighting: "lambert" });
    expect(await said(page, "error")).toBe("");
    expect(await said(page, "warning")).toBe("");
  });

  test("a change on disk is seen; what was changed on the page stays", async () => {
    const { page } = lab;
    await page.evaluate(() => window.lustro.update("shading.interpolation", "flat"));
    await settled(page);
    const before = await hashOf(page);
    write("scene.json", JSON.stringify({ ...kScene, objects: [{ mesh: "square.obj" }, { mesh: "primitive:cube" }] }));
    await page.waitForFunction(() => window.lustro.scene.value.objects.length === 2);
    await settled(page);
    expect(await page.evaluate(() => window.lustro.picture.value!.triangles)).toBe(14);
    expect(await page.evaluate(() => window.lustro.scene.value.shading)).toMatchObject({ lighting: "lambert", interpolation: "flat" });
    expect(await hashOf(page)).not.toBe(before);
  });

  test("a change of a mesh that the scene names is seen", async () => {
    const { page } = lab;
    write(kObj.name, Buffer.from(kObj.bytes).toString().replace("f 1/1 2/2 3/3 4/4", "f 1/1 2/2 3/3"));
    await page.waitForFunction(() => window.lustro.picture.value!.triangles === 13);
    await settled(page);
  });

  test("what breaks on disk is told with its place; the page keeps what it had until it is mended", async () => {
    const { page } = lab;
    const before = await hashOf(page);
    write(kObj.name, broken.obj.bytes);
    await expect.poll(() => said(page, "error"), { timeout: 15_000 }).toMatch(/square\.obj:5.*9/);
    expect(await hashOf(page)).toBe(before);
    write(kObj.name, kObj.bytes);
    await page.waitForFunction(() => window.lustro.picture.value!.triangles === 14);
    await expect.poll(() => said(page, "error"), { message: "the cause is gone" }).toBe("");
  });

  test("no foreign name leads to the server, which gives nothing else of the disk and lets nothing be changed", async () => {
    const { host, port } = new URL(url);
    expect(await statusOf("/", { host })).toBe(200);
    expect(await statusOf("/api/files/scene.json", { host: `localhost:${port}` })).toBe(200);
    for (const name of [`evil.example:${port}`, "evil.example", "127.0.0.1:1"]) {
      expect(await statusOf("/", { host: name }), name).toBe(403);
      expect(await statusOf("/api/files/scene.json", { host: name }), name).toBe(403);
    }
    expect(await statusOf("/api/model", { host, "sec-fetch-site": "cross-site" })).toBe(403);
    write("secret.txt", "not the model's");
    expect(await statusOf("/api/files/secret.txt", { host })).toBe(404);
    expect(await statusOf("/api/files/..%2f..%2fetc%2fpasswd", { host })).toBeGreaterThanOrEqual(400);
    expect(await statusOf("/api/model", { host }, "POST")).toBeGreaterThanOrEqual(400);
  });
});
