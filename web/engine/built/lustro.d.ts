// What web/engine/bindings.cpp gives to JavaScript. The module itself is built by scripts/lab.
export interface LabHandle {
  open(entry: string): string;
  render(scene: string, width: number, height: number, samples: number, floats: boolean, hash: boolean, share: number, shares: number): string;
  explain(scene: string, width: number, height: number, samples: number, x: number, y: number): string;
  meshes(scene: string): string;
  gpuScene(scene: string, width: number, height: number, samples: number, linear: boolean): string;
  gpuGeometry(key: string): string;
  sceneFile(scene: string): string;
  commandLine(scene: string, width: number, height: number, samples: number): string;
  glsl(scene: string): string;
  /** views of the engine's memory, good until the next call */
  bytes(): Uint8Array;
  floats(): Float32Array;
  positions(): Float32Array;
  normals(): Float32Array;
  centers(): Float32Array;
  indices(): Uint32Array;
}

export interface EngineModule {
  Lab: new () => LabHandle;
  engineInfo(): string;
  options(): string;
  materials(): string;
  FS: {
    mkdir(path: string): void;
    rmdir(path: string): void;
    unlink(path: string): void;
    readdir(path: string): string[];
    stat(path: string): { mode: number };
    isDir(mode: number): boolean;
    analyzePath(path: string): { exists: boolean };
    writeFile(path: string, bytes: Uint8Array): void;
  };
}

export interface DecodedPicture {
  width: number;
  height: number;
  /** 1 gray, 3 colour, 4 with alpha */
  channels: number;
  depth: 8 | 16;
  data: Uint8Array | Uint16Array;
}

export default function createModule(options: {
  /** gives the module's instance to `receive` */
  instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void): object;
  decodePicture(format: string, bytes: Uint8Array): DecodedPicture | { error: string };
}): Promise<EngineModule>;
