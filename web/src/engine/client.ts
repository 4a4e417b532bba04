// The engine as the page calls it: a team of workers, each with the whole scene, that draw pictures together. The first one also answers
// everything else. A worker that crashes is started again with the files that were open.
import * as Comlink from "comlink";
import programUrl from "../../engine/built/lustro.wasm?url";
import {
  EngineError,
  type Engine,
  type EngineFile,
  type EngineInfo,
  type Explanation,
  type GpuGeometry,
  type GpuScene,
  type MeshInfo,
  type Opened,
  type OptionGroup,
  type Picture,
  type RenderRequest,
  type SceneDoc,
} from "./types";
import type { Answer, SharePicture, WorkerApi } from "./worker";

/** More workers than this gain little: each prepares the scene for itself. */
const kMostWorkers = 8;
/** A model whose files are larger is held once: every worker has a copy. */
const kSharedBytes = 256 << 20;

interface Member {
  worker: Worker;
  api: Comlink.Remote<WorkerApi>;
}

export interface EngineSetup {
  /** 0: as many workers as the machine has cores */
  threads?: number;
  /** called when Engine.info has changed: the first worker answers calls before the others are there */
  onInfo?: (info: EngineInfo) => void;
}

interface Waiting {
  request: RenderRequest;
  resolve: (picture: Picture) => void;
  reject: (reason: unknown) => void;
}

const aborted = () => new DOMException("a newer picture was asked for", "AbortError");

function unwrapped<T>(answer: Answer<T>): T {
  if ("error" in answer) {
    throw new EngineError(answer.error.kind, answer.error.where, answer.error.message);
  }
  return answer.value;
}

/** The model among files: a scene file, else a glTF, else the largest mesh. */
export function entryOf(files: EngineFile[]): string | undefined {
  const of = (pattern: RegExp) => files.filter((file) => pattern.test(file.path)).sort((a, b) => b.bytes.length - a.bytes.length)[0]?.path;
  return of(/\.json$/i) ?? of(/\.(gltf|glb)$/i) ?? of(/\.(obj|ply|stl|off|3mf)$/i) ?? (files.length === 1 ? files[0]!.path : undefined);
}

/** A path as the engine's file system takes it: relative, without `.` and `..`. */
function checkedPath(path: string): string {
  const parts = path.replaceAll("\\", "/").split("/").filter((part) => part !== "" && part !== ".");
  if (parts.length === 0 || parts.includes("..")) {
    throw new EngineError("usage", path, "is no path of a file");
  }
  return parts.join("/");
}

class Team implements Engine {
  info!: EngineInfo;
  private program!: WebAssembly.Module;
  private members: Member[] = [];
  private joining: Promise<void> = Promise.resolve();
  private files: EngineFile[] = [];
  private entry = "";
  private isDrawing = false;
  private waiting: Waiting[] = [];
  private newest: Waiting | undefined;

  constructor(private readonly setup: EngineSetup) {}

  /** One worker is enough to begin with; the others join when they are ready. */
  async start(): Promise<void> {
    this.program = await fetchProgram();
    const { member, about } = await this.startMember();
    this.members = [member];
    const cores = this.setup.threads || navigator.hardwareConcurrency || 1;
    const count = Math.max(1, Math.min(cores, kMostWorkers));
    this.setInfo({
      ...about,
      threads: 1,
      singleThreadedBecause: count > 1 ? "the other workers are still starting" : this.setup.threads === 1 ? "one thread was asked for" : "this machine has one core",
    });
    if (count > 1) {
      this.joining = this.startOthers(count - 1);
    }
  }

  /** All workers that there will be are there. */
  complete(): Promise<void> {
    return this.joining;
  }

  private setInfo(info: EngineInfo): void {
    this.info = info;
    this.setup.onInfo?.(info);
  }

  private async startOthers(count: number): Promise<void> {
    const started = await Promise.allSettled(Array.from({ length: count }, () => this.startMember()));
    for (const other of started) {
      if (other.status === "fulfilled") {
        await this.join(other.value.member);
      }
    }
    const threads = this.members.length;
    this.setInfo({ ...this.info, threads, singleThreadedBecause: threads > 1 ? "" : "the browser started no further workers" });
  }

  /** A new worker opens what the others have open, whatever is opened meanwhile. */
  private async join(member: Member): Promise<void> {
    for (;;) {
      const files = this.files;
      if (files.length > 0) {
        await member.api.open(files, this.entry);
      }
      if (files === this.files) {
        this.members.push(member);
        return;
      }
    }
  }

  private async startMember(): Promise<{ member: Member; about: { version: string; target: string } }> {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    const api = Comlink.wrap<WorkerApi>(worker);
    const broken = new Promise<never>((_, reject) => {
      worker.addEventListener("error", (event) => reject(new EngineError("crash", "", event.message || "the engine's worker did not start")), { once: true });
    });
    const about = await Promise.race([api.start(this.program), broken]);
    return { member: { worker, api }, about };
  }

  /** A call of one worker. One that crashed is replaced before its error is told. */
  private async call<T>(index: number, ask: (api: Comlink.Remote<WorkerApi>) => Promise<Answer<T>>): Promise<T> {
    const answer = await ask(this.members[index]!.api);
    if ("error" in answer && answer.error.kind === "crash") {
      this.members[index]!.worker.terminate();
      const { member } = await this.startMember();
      this.members[index] = member;
      if (this.files.length > 0) {
        await member.api.open(this.files, this.entry);
      }
    }
    return unwrapped(answer);
  }

  private first<T>(ask: (api: Comlink.Remote<WorkerApi>) => Promise<Answer<T>>): Promise<T> {
    return this.call(0, ask);
  }

  options(): Promise<OptionGroup[]> {
    return this.first((api) => api.options());
  }

  materials(): Promise<{ name: string; table: Record<string, unknown> }[]> {
    return this.first((api) => api.materials());
  }

  async open(files: EngineFile[], entry?: string): Promise<Opened> {
    const named = files.map((file) => ({ path: checkedPath(file.path), bytes: file.bytes }));
    const chosen = entry === undefined ? entryOf(named) : checkedPath(entry);
    if (chosen === undefined) {
      throw new EngineError("usage", "", "none of these files is a model or a scene: OBJ, PLY, STL, OFF, glTF, GLB and scene files (JSON) are");
    }
    const before = { files: this.files, entry: this.entry };
    this.files = named;
    this.entry = chosen;
    const size = named.reduce((bytes, file) => bytes + file.bytes.length, 0);
    if (size > kSharedBytes) {
      for (const member of this.members.splice(1)) {
        member.worker.terminate();
      }
      this.setInfo({ ...this.info, threads: 1, singleThreadedBecause: "the model is too large to be held more than once" });
    }
    try {
      // All have answered before any goes back to the files before.
      const answers = await Promise.allSettled(this.members.map((_, index) => this.call(index, (api) => api.open(named, chosen))));
      const refused = answers.find((answer) => answer.status === "rejected");
      if (refused) {
        throw refused.reason;
      }
      const opened = (answers[0] as PromiseFulfilledResult<Opened>).value;
      if (!(await this.meshes(opened.scene)).some(({ triangles }) => triangles > 0)) {
        throw new EngineError("empty", chosen, "has no triangles that could be drawn");
      }
      return opened;
    } catch (problem) {
      this.files = before.files;
      this.entry = before.entry;
      if (before.files.length > 0) {
        await Promise.all(this.members.map((member) => member.api.open(before.files, before.entry)));
      }
      throw problem;
    }
  }

  render(request: RenderRequest, keep = false): Promise<Picture> {
    return new Promise((resolve, reject) => {
      const waiting = { request, resolve, reject };
      if (keep) {
        this.waiting.push(waiting);
      } else {
        this.newest?.reject(aborted());
        this.newest = waiting;
      }
      void this.drawNext();
    });
  }

  private async drawNext(): Promise<void> {
    if (this.isDrawing) {
      return;
    }
    const next = this.newest ?? this.waiting.shift();
    if (!next) {
      return;
    }
    if (next === this.newest) {
      this.newest = undefined;
    }
    this.isDrawing = true;
    try {
      next.resolve(await this.draw(next.request));
    } catch (problem) {
      next.reject(problem);
    } finally {
      this.isDrawing = false;
      void this.drawNext();
    }
  }

  /** One picture by all workers; by one where the hash is asked for, which is of the whole. */
  private async draw(request: RenderRequest): Promise<Picture> {
    const begin = performance.now();
    const { width, height, samples = 0 } = request;
    const scene = JSON.stringify(request.scene);
    const wants = { floats: request.floats ?? false, hash: request.hash ?? false, aside: request.aside ?? false };
    const shares = wants.hash || wants.aside ? 1 : this.members.length;
    const parts = await Promise.all(
      Array.from({ length: shares }, (_, share) =>
        this.call(share, (api) => api.render(scene, width, height, samples, wants, share, shares) as Promise<Answer<SharePicture>>),
      ),
    );
    const { bands: _bands, ...head } = parts[0]!;
    const picture: Picture = { ...head, milliseconds: performance.now() - begin };
    picture.pixelsCovered = parts.reduce((sum, part) => sum + part.pixelsCovered, 0);
    if (shares > 1) {
      const row = picture.width * 4;
      picture.bytes = new Uint8ClampedArray(row * picture.height);
      if (wants.floats) {
        picture.floats = new Float32Array(row * picture.height);
      }
      for (const part of parts) {
        let at = 0;
        for (const [from, to] of part.bands) {
          const length = (to - from) * row;
          picture.bytes.set(part.bytes.subarray(at, at + length), from * row);
          picture.floats?.set(part.floats!.subarray(at, at + length), from * row);
          at += length;
        }
      }
    }
    return picture;
  }

  explain(request: RenderRequest, x: number, y: number): Promise<Explanation> {
    return this.first((api) => api.explain(JSON.stringify(request.scene), request.width, request.height, request.samples ?? 0, x, y));
  }

  meshes(scene: SceneDoc): Promise<MeshInfo[]> {
    return this.first((api) => api.meshes(JSON.stringify(scene)));
  }

  gpuScene(request: RenderRequest, linear = false): Promise<GpuScene> {
    return this.first((api) => api.gpuScene(JSON.stringify(request.scene), request.width, request.height, request.samples ?? 0, linear));
  }

  gpuGeometry(key: string): Promise<GpuGeometry> {
    return this.first((api) => api.gpuGeometry(key) as Promise<Answer<GpuGeometry>>);
  }

  async sceneFile(scene: SceneDoc): Promise<string> {
    return (await this.first((api) => api.sceneFile(JSON.stringify(scene)))).text;
  }

  commandLine(request: RenderRequest): Promise<{ command: string; file?: string }> {
    return this.first((api) => api.commandLine(JSON.stringify(request.scene), request.width, request.height, request.samples ?? 0));
  }

  glsl(scene: SceneDoc): Promise<{ vertex: string; fragment: string }> {
    return this.first((api) => api.glsl(JSON.stringify(scene)));
  }
}

/** Starts the engine. Rejects with an EngineError where the browser has no WebAssembly or no workers, or its files cannot be fetched. */
export async function createEngine(setup: EngineSetup = {}): Promise<Engine> {
  if (typeof WebAssembly !== "object") {
    throw new EngineError("unsupported", "", "this browser has no WebAssembly, in which the engine is written");
  }
  if (typeof Worker !== "function") {
    throw new EngineError("unsupported", "", "this browser has no workers, in which the engine runs");
  }
  const team = new Team(setup);
  await team.start();
  return team;
}

/** The engine's program, compiled while it arrives where the web host states its type. */
async function fetchProgram(): Promise<WebAssembly.Module> {
  const answer = await fetch(programUrl, { credentials: "same-origin" });
  if (!answer.ok) {
    throw new EngineError("io", programUrl, `the engine cannot be fetched: ${answer.status} ${answer.statusText}`);
  }
  const isTyped = answer.headers.get("content-type")?.startsWith("application/wasm") ?? false;
  return isTyped ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}
