// One worker of the engine: the WebAssembly module, its files, and answers to calls (comlink). Several of these draw a picture together, each
// with a memory of its own, so no shared memory is needed.
import * as Comlink from "comlink";
import createModule, { type EngineModule, type LabHandle } from "../../engine/built/lustro.js";
import { decodePicture, preparePictures } from "./pictures";
import type { EngineFile, Explanation, GpuGeometry, GpuScene, MeshInfo, Opened, OptionGroup, Picture } from "./types";

/** A picture's rows as one worker drew them. */
export interface SharePicture extends Omit<Picture, "bytes" | "floats" | "milliseconds"> {
  /** rows of pixels, [begin, end) */
  bands: [number, number][];
  /** the bands one after the other */
  bytes: Uint8ClampedArray<ArrayBuffer>;
  floats?: Float32Array<ArrayBuffer>;
}

/** What a call answers: a value, or the error's parts (class instances do not travel between workers). */
export type Answer<T> = { value: T } | { error: { kind: string; where: string; message: string } };

const kFiles = "/files";

let module: EngineModule;
let lab: LabHandle;
/** Draws what is no matter of the page's scene. */
let aside: LabHandle | undefined;

function answer<T>(text: string): Answer<T> {
  const json = JSON.parse(text);
  return json !== null && typeof json === "object" && "error" in json ? { error: json.error } : { value: json };
}

/** What the module throws when it gives up: its memory can no longer be trusted, the client starts another worker. */
function guarded<T>(call: () => Answer<T>): Answer<T> {
  try {
    return call();
  } catch (problem) {
    return { error: { kind: "crash", where: "", message: `the engine stopped: ${problem instanceof Error ? problem.message : String(problem)}` } };
  }
}

function removeTree(path: string): void {
  for (const name of module.FS.readdir(path)) {
    if (name === "." || name === "..") {
      continue;
    }
    const inner = `${path}/${name}`;
    if (module.FS.isDir(module.FS.stat(inner).mode)) {
      removeTree(inner);
      module.FS.rmdir(inner);
    } else {
      module.FS.unlink(inner);
    }
  }
}

/** Copies the bands of a picture's rows out of the engine's memory. */
function copyBands<A extends Uint8Array | Float32Array>(whole: A, bands: [number, number][], row: number, make: (length: number) => A): A {
  const result = make(bands.reduce((rows, [begin, end]) => rows + end - begin, 0) * row);
  let at = 0;
  for (const [begin, end] of bands) {
    result.set(whole.subarray(begin * row, end * row), at);
    at += (end - begin) * row;
  }
  return result;
}

const api = {
  /** The program is compiled once, by the page, for all workers. */
  async start(program: WebAssembly.Module): Promise<{ version: string; target: string }> {
    module = await new Promise((resolve, reject) => {
      const instantiateWasm = (imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance, from: WebAssembly.Module) => void) => {
        WebAssembly.instantiate(program, imports).then((instance) => receive(instance, program), reject);
        return {};
      };
      createModule({ instantiateWasm, decodePicture }).then(resolve, reject);
    });
    module.FS.mkdir(kFiles);
    lab = new module.Lab();
    return JSON.parse(module.engineInfo());
  },

  options(): Answer<OptionGroup[]> {
    return answer(module.options());
  },

  materials(): Answer<{ name: string; table: Record<string, unknown> }[]> {
    return answer(module.materials());
  },

  async open(files: EngineFile[], entry: string): Promise<Answer<Opened>> {
    await preparePictures(files);
    return guarded(() => {
      removeTree(kFiles);
      for (const file of files) {
        const parts = file.path.split("/");
        for (let depth = 1; depth < parts.length; ++depth) {
          const folder = `${kFiles}/${parts.slice(0, depth).join("/")}`;
          if (!module.FS.analyzePath(folder).exists) {
            module.FS.mkdir(folder);
          }
        }
        module.FS.writeFile(`${kFiles}/${file.path}`, file.bytes);
      }
      return answer(lab.open(entry));
    });
  },

  render(
    scene: string,
    width: number,
    height: number,
    samples: number,
    wants: { floats: boolean; hash: boolean; aside: boolean },
    share: number,
    shares: number,
  ): Answer<SharePicture> {
    return guarded(() => {
      const drawer = wants.aside ? (aside ??= new module.Lab()) : lab;
      const drawn = answer<SharePicture>(drawer.render(scene, width, height, samples, wants.floats, wants.hash, share, shares));
      if ("error" in drawn) {
        return drawn;
      }
      const picture = drawn.value;
      const bytes = copyBands(drawer.bytes(), picture.bands, picture.width * 4, (length) => new Uint8Array(length));
      picture.bytes = new Uint8ClampedArray(bytes.buffer as ArrayBuffer);
      const moved: Transferable[] = [picture.bytes.buffer];
      if (wants.floats) {
        picture.floats = copyBands(drawer.floats(), picture.bands, picture.width * 4, (length) => new Float32Array(length)) as Float32Array<ArrayBuffer>;
        moved.push(picture.floats.buffer);
      }
      return Comlink.transfer(drawn, moved);
    });
  },

  explain(scene: string, width: number, height: number, samples: number, x: number, y: number): Answer<Explanation> {
    return guarded(() => answer(lab.explain(scene, width, height, samples, x, y)));
  },

  meshes(scene: string): Answer<MeshInfo[]> {
    return guarded(() => answer(lab.meshes(scene)));
  },

  gpuScene(scene: string, width: number, height: number, samples: number, linear: boolean): Answer<GpuScene> {
    return guarded(() => {
      const scene_answer = answer<GpuScene>(lab.gpuScene(scene, width, height, samples, linear));
      if ("value" in scene_answer) {
        const value = scene_answer.value;
        value.clipFromEye = new Float32Array(value.clipFromEye);
        for (const instance of value.instances) {
          instance.eyeFromObject = new Float32Array(instance.eyeFromObject);
          instance.normalFromObject = new Float32Array(instance.normalFromObject);
        }
      }
      return scene_answer;
    });
  },

  gpuGeometry(key: string): Answer<GpuGeometry> {
    return guarded(() => {
      const made = answer<object>(lab.gpuGeometry(key));
      if ("error" in made) {
        return made;
      }
      const geometry: GpuGeometry = {
        positions: lab.positions().slice() as Float32Array<ArrayBuffer>,
        normals: lab.normals().slice() as Float32Array<ArrayBuffer>,
        indices: lab.indices().slice() as Uint32Array<ArrayBuffer>,
      };
      const centers = lab.centers();
      if (centers.length > 0) {
        geometry.centers = centers.slice() as Float32Array<ArrayBuffer>;
      }
      const moved = [geometry.positions, geometry.normals, geometry.indices, ...(geometry.centers ? [geometry.centers] : [])];
      return Comlink.transfer({ value: geometry }, moved.map((array) => array.buffer));
    });
  },

  sceneFile(scene: string): Answer<{ text: string }> {
    return guarded(() => answer(lab.sceneFile(scene)));
  },

  commandLine(scene: string, width: number, height: number, samples: number): Answer<{ command: string; file?: string }> {
    return guarded(() => answer(lab.commandLine(scene, width, height, samples)));
  },

  glsl(scene: string): Answer<{ vertex: string; fragment: string }> {
    return guarded(() => answer(lab.glsl(scene)));
  },
};

export type WorkerApi = typeof api;

Comlink.expose(api);
