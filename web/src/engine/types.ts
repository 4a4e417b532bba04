// What the page and the engine say to each other. The engine is the library itself, in WebAssembly, in a worker; everything that it is asked
// and answers stands here. Scenes travel as scene files (docs/using/scene-file.md), explanations as `lustro explain --json` prints them.

/** A scene file's content. Keys that are not stated have their defaults (see OptionGroup). */
export interface SceneDoc {
  image?: Record<string, unknown>;
  camera?: Record<string, unknown>;
  shading?: Record<string, unknown>;
  lights?: Record<string, unknown>[];
  materials?: Record<string, unknown>;
  objects: SceneObject[];
  [key: string]: unknown;
}

export interface SceneObject {
  name?: string;
  /** `primitive:teapot`, `primitive:sphere:24`, or a file that was opened, by its path */
  mesh: string;
  material?: string | Record<string, unknown>;
  [key: string]: unknown;
}

export type Vec3 = [number, number, number];

/** A file that was dropped, chosen or fetched. */
export interface EngineFile {
  /** relative, with `/`: `bunny.obj`, `textures/wood.png` */
  path: string;
  bytes: Uint8Array;
}

/** Something that the engine refuses, in its own words. */
export class EngineError extends Error {
  constructor(
    /** `usage`, `io`, `malformed`, `unsupported`, `limit`, `empty`, or `crash` where the engine itself gave up (it is started again) */
    readonly kind: string,
    /** file and place: `model.obj:17`, `scene.json: lights[2].cutoff`; may be empty */
    readonly where: string,
    message: string,
  ) {
    super(where === "" ? message : `${where}: ${message}`);
    this.name = "EngineError";
  }
}

/** A model or scene that was opened: the page goes on with `scene`. */
export interface Opened {
  /** as a scene file says it; its objects name meshes that the engine now holds */
  scene: SceneDoc;
  notes: string[];
  cameras: string[];
  animations: string[];
}

/** The camera made definite: what the scene leaves open is chosen. World space, lengths in world units. */
export interface ViewInfo {
  projection: "perspective" | "orthographic";
  eye: Vec3;
  target: Vec3;
  right: Vec3;
  up: Vec3;
  forward: Vec3;
  near: number;
  far: number;
  /** pixels a world unit: at distance 1 (perspective), everywhere (orthographic), at the picture's size below */
  pixelsPerUnit: number;
  width: number;
  height: number;
  /** of everything that is drawn */
  lower: Vec3;
  upper: Vec3;
}

/** A light as it shines: stated by the scene, or of the default rig. */
export interface LightInfo {
  type: "directional" | "point" | "spot" | "rectangle" | "disk" | "sphere";
  name: string;
  position: Vec3;
  direction: Vec3;
  /** the entry as a scene file would state it: what `lights` becomes when the default rig is to be changed */
  stated: Record<string, unknown>;
}

export interface RenderRequest {
  scene: SceneDoc;
  /** pixels; they override the scene's image.width and image.height. A smaller picture of the same shape shows the same view */
  width: number;
  height: number;
  /** coverage samples a pixel, overrides image.samples: 1 while dragging */
  samples?: number;
  /** also the linear floats: what the plots and the comparison of numbers need */
  floats?: boolean;
  /** drawn apart from the page's scene, whose meshes stay as they are: thumbnails, say */
  aside?: boolean;
  /** also the hash (it takes a few milliseconds a megapixel) */
  hash?: boolean;
}

/** milliseconds; RenderTimes of include/lustro/render.hpp */
export interface StageTimes {
  prepare: number;
  shadows: number;
  cull: number;
  visibility: number;
  shading: number;
  total: number;
}

export interface Picture {
  width: number;
  height: number;
  /** RGBA, straight alpha, as ImageData takes it: the very bytes of the PNG */
  bytes: Uint8ClampedArray<ArrayBuffer>;
  /** width x height x 4, linear, alpha premultiplied; where asked for */
  floats?: Float32Array<ArrayBuffer>;
  /** 16 hexadecimal digits, those of `lustro hash`; where asked for */
  hash?: string;
  /** of the whole call */
  milliseconds: number;
  /** of it, what the first worker's engine took for its share, stage by stage */
  times: StageTimes;
  triangles: number;
  pixelsCovered: number;
  view: ViewInfo;
  lights: LightInfo[];
  notes: string[];
}

/** `lustro explain --json`: src of truth is app/explain_json.cpp. */
export interface Explanation {
  x: number;
  y: number;
  interpolation: "flat" | "gouraud" | "phong";
  samples: number;
  /** I_a */
  ambient_light: Vec3;
  /** the lobes are normalised: `shading.normalized` */
  normalized: boolean;
  fragments: FragmentExplanation[];
  background_weight: number;
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  emission: Vec3;
  fog: Vec3;
  background: Vec3;
  color: [number, number, number, number];
  bytes: [number, number, number, number];
  /** of the first fragment's triangle, world: its corners and their normals (unit); absent over the background */
  triangle?: { positions: [Vec3, Vec3, Vec3]; normals: [Vec3, Vec3, Vec3] };
}

export interface FragmentExplanation {
  object: number;
  object_name: string;
  triangle: number;
  material: number;
  material_name: string;
  front: boolean;
  samples: number;
  opacity: number;
  weight: number;
  x: number;
  y: number;
  depth: number;
  barycentrics: Vec3;
  position: Vec3;
  lighting: string;
  /** the material, linear, as the maps leave it; what the equation took is in `shadings` */
  coefficients: Record<string, unknown> & {
    ambient: MaterialColor;
    diffuse: MaterialColor;
    specular: MaterialColor;
    emission: MaterialColor;
    shininess: number;
  };
  maps: { map: string; name: string; u: number; v: number; level_of_detail: number; value: number[]; applies: boolean }[];
  shadings: ShadingExplanation[];
  /** what maps multiply the light of a face or of vertices by, term by term; 1 where they change coefficients instead */
  maps_ambient: Vec3;
  maps_diffuse: Vec3;
  maps_specular: Vec3;
  maps_emission: Vec3;
  /** k_s times the reflection map, part of specular */
  reflection: Vec3;
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  emission: Vec3;
  fog: Vec3;
  fog_factor: number;
}

export interface MaterialColor {
  rgb: Vec3;
  space: "linear" | "srgb";
}

/** One evaluation of the equation: a pixel's for `phong`, a face's for `flat`, a vertex's for `gouraud`. */
export interface ShadingExplanation {
  weight: number;
  position: Vec3;
  normal: Vec3;
  to_eye: Vec3;
  /** of this evaluation: under vertex colours and maps, but for maps that come after it; 0 where a term is switched off */
  k_ambient: Vec3;
  k_diffuse: Vec3;
  k_specular: Vec3;
  k_emission: Vec3;
  shininess: number;
  /** what a vertex's terms are multiplied by, so that their sum is at most 1 */
  clamp: Vec3;
  openness: number;
  scene_ambient: Vec3;
  /** a k_d E */
  environment: Vec3;
  /** E */
  from_environment: Vec3;
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  emission: Vec3;
  lights: LightExplanation[];
}

export interface LightExplanation {
  light: number;
  name: string;
  to_light: Vec3;
  reflected: Vec3;
  half: Vec3;
  distance: number;
  n_dot_l: number;
  r_dot_v: number;
  n_dot_h: number;
  attenuation: number;
  spot: number;
  visibility: number;
  /** l_a, l_d, l_s, linear */
  light_ambient: Vec3;
  light_diffuse: Vec3;
  light_specular: Vec3;
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
}

/** One key of the scene file, from the library's table of options: the page makes its controls of it. */
export interface Option {
  key: string;
  /** of the command, `--samples`; empty where there is none */
  flag: string;
  help: string;
  /** `degrees`, `pixels`, ... or empty */
  unit: string;
  /** `boolean`, `integer`, `number`, `vector`, `matrix`, `color`, `color_alpha`, `word`, `terms`, `text`, `table`, `lights`, `objects`,
   * `material`, `materials`, `texture`, `reflection`, `wrap`, `pair`, `triple`, `affine`, `toggle` */
  kind: string;
  /** "not stated" is a value of its own */
  optional: boolean;
  minimum?: number;
  maximum?: number;
  minimumOpen?: boolean;
  maximumOpen?: boolean;
  /** only these numbers */
  allowed?: number[];
  /** what holds where the key is not stated, as the command line writes it */
  default: string;
  words: { word: string; help: string }[];
}

export interface OptionGroup {
  /** `image`, `camera`, `shading`, `lights[]`, `lights[].attenuation`, ...; empty for the scene's own keys */
  path: string;
  help: string;
  options: Option[];
}

/** Everything WebGL2 needs to draw the scene with the engine's own shaders. Column-major matrices, as WebGL takes them. */
export interface GpuScene {
  width: number;
  height: number;
  /** the engine's samples, from a pixel's centre, in pixels, x to the right, y down */
  pattern: [number, number][];
  /** eye is the origin, world orientation */
  clipFromEye: Float32Array<ArrayBuffer>;
  viewToEye: Vec3;
  ambientLight: Vec3;
  /** linear, premultiplied */
  background: [number, number, number, number];
  /** the uniform `fog` of src/shade/fog.glsl */
  fog?: { mode: number; density: number; end: number; range_scale: number; color: Vec3 };
    /** the picture is stored as sRGB */
  encoded: boolean;
  /** of several samples: the shaders give linear light, which is encoded after they are averaged */
  linearShaders: boolean;
  twoSided: boolean;
  lights: GpuLight[];
  /** programs by the lighting model of the materials that are there: GLSL ES 3.00 */
  programs: { lighting: string; vertex: string; fragment: string }[];
  instances: GpuInstance[];
  /** what the GPU's picture leaves out: textures, shadows, more lights than fit, ...; each a sentence */
  missing: string[];
}

/** The uniform `lights[i]` of src/shade/lighting.glsl, member by member. */
export interface GpuLight {
  type: number;
  position: Vec3;
  travel: Vec3;
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  attenuation: Vec3;
  falloff: number;
  attenuation_limit: number;
  range_scale: number;
  cos_cutoff: number;
  cos_beam: number;
  beam_scale: number;
  fades_quadratically: boolean;
  exponent: number;
}

export interface GpuInstance {
  /** equal keys have equal geometry: buffers can be kept */
  geometry: string;
  eyeFromObject: Float32Array<ArrayBuffer>;
  normalFromObject: Float32Array<ArrayBuffer>;
  /** the matrix turns the winding round */
  mirrored: boolean;
  /** runs of indices with one material each */
  parts: { first: number; count: number; program: number; cull: "none" | "back" | "front"; material: GpuMaterial }[];
}

export interface GpuMaterial {
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  emission: Vec3;
  shininess: number;
}

/** Vertices of one instance's mesh. `flat` shading has three vertices of its own a triangle, with the face's centre and normal. */
export interface GpuGeometry {
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer>;
  /** `flat` alone: face_center */
  centers?: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
}

/** What an object shows. */
export interface MeshInfo {
  /** the object's name, else its source */
  name: string;
  vertices: number;
  triangles: number;
  /** of the mesh where it stands, world */
  lower: Vec3;
  upper: Vec3;
  hasUvs: boolean;
  hasColors: boolean;
  /** of the mesh's own materials, as scene files state them: what shows where the object states none */
  materials: { name: string; table: Record<string, unknown> }[];
}

/** How the engine runs. */
export interface EngineInfo {
  /** the library's version */
  version: string;
  /** workers that draw a picture together, each its share of the rows: no shared memory is needed, so any web host will do */
  threads: number;
  /** the row of kernels: `wasm` (SIMD) or `scalar` */
  target: string;
  /** why there is one worker alone; empty where there are more */
  singleThreadedBecause: string;
}

/** The engine, as the page calls it (web/src/engine/client.ts). Every call may reject with an EngineError. */
export interface Engine {
  readonly info: EngineInfo;
  /** all workers that there will be have joined; calls need not wait for that */
  complete(): Promise<void>;
  options(): Promise<OptionGroup[]>;
  /** names and tables of coefficients (as scene files state them) of the 29 library materials */
  materials(): Promise<{ name: string; table: Record<string, unknown> }[]>;
  /** The files replace all that were opened before. `entry` is the scene or model among them; without one it is found: a scene file, else a
   * glTF, else the largest mesh. */
  open(files: EngineFile[], entry?: string): Promise<Opened>;
  /** A newer call makes an older one that has not begun reject with a DOMException `AbortError`, so that dragging never queues up;
   * `keep` says that this one must be answered whatever comes after it. */
  render(request: RenderRequest, keep?: boolean): Promise<Picture>;
  /** The pixel taken apart, x and y in the picture of the request's size and samples. */
  explain(request: RenderRequest, x: number, y: number): Promise<Explanation>;
  /** Mesh facts of what is shown, as `lustro info --json` names them. */
  meshes(scene: SceneDoc): Promise<MeshInfo[]>;
  /** linear   for a target of floats, whose samples are averaged before they are encoded */
  gpuScene(request: RenderRequest, linear?: boolean): Promise<GpuScene>;
  gpuGeometry(key: string): Promise<GpuGeometry>;
  /** The scene as the library writes it: only keys that differ from their defaults, in the documented order. */
  sceneFile(scene: SceneDoc): Promise<string>;
  /** `lustro render ...`: the exact command. Where flags cannot say everything, it names `scene.json`, and `file` is its content. */
  commandLine(request: RenderRequest): Promise<{ command: string; file?: string }>;
  /** Complete shaders of the current setting. */
  glsl(scene: SceneDoc): Promise<{ vertex: string; fragment: string }>;
}
