// The engine itself under Node, without a worker: for tests that ask it. Undefined where it is not built (scripts/lab builds it).
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import type { Engine, Explanation, Picture, RenderRequest } from "../../src/engine/types";
import type { EngineModule } from "../../engine/built/lustro.js";

const kBuilt = fileURLToPath(new URL("../../engine/built/", import.meta.url));

function parsed<T>(text: string): T {
  const json = JSON.parse(text) as T & { error?: { where: string; message: string } };
  if (json.error) {
    throw new Error(`${json.error.where}: ${json.error.message}`);
  }
  return json;
}

export const isEngineBuilt = existsSync(`${kBuilt}lustro.js`) && existsSync(`${kBuilt}lustro.wasm`);

export async function nodeEngine(): Promise<Pick<Engine, "render" | "explain">> {
  // what Emscripten's glue expects of a CommonJS file
  Object.assign(globalThis, { require: createRequire(import.meta.url), __dirname: kBuilt, __filename: `${kBuilt}lustro.js` });
  const { default: create } = (await import(/* @vite-ignore */ `${kBuilt}lustro.js`)) as {
    default: (options: object) => Promise<EngineModule>;
  };
  const module = await create({ wasmBinary: readFileSync(`${kBuilt}lustro.wasm`), decodePicture: () => ({ error: "no pictures here" }) });
  module.FS.mkdir("/files");
  const lab = new module.Lab();
  return {
    async render({ scene, width, height, samples, floats, hash }: RenderRequest): Promise<Picture> {
      const head = parsed<Picture>(lab.render(JSON.stringify(scene), width, height, samples ?? 0, floats ?? false, hash ?? false, 0, 1));
      head.bytes = new Uint8ClampedArray(lab.bytes());
      if (floats) {
        head.floats = new Float32Array(lab.floats());
      }
      return head;
    },
    async explain({ scene, width, height, samples }: RenderRequest, x: number, y: number): Promise<Explanation> {
      return parsed<Explanation>(lab.explain(JSON.stringify(scene), width, height, samples ?? 0, x, y));
    },
  };
}
