// Every key of the scene file, and where the page's control for it is tested: by operate.ts in one of these scenes, each made so that each of
// its controls is seen in the picture, or by a test of its own.
import type { SceneDoc } from "../../src/engine/types";
import type { Control } from "./operate";

export interface Bench {
  name: string;
  tab: "shading" | "material" | "lights" | "camera" | "scene";
  scene: SceneDoc;
  /** pictures that lie beside the scene */
  pictures?: readonly string[];
  controls: readonly Control[];
}

const place = (x: number, y: number, z: number, size = 1) => [size, 0, 0, x, 0, size, 0, y, 0, 0, size, z, 0, 0, 0, 1];

const kPaint = { ambient: [0.5, 0.3, 0.2], diffuse: [0.6, 0.3, 0.2], specular: [0.5, 0.5, 0.5], emission: [0.1, 0.04, 0], shininess: 20 };
const kSun = { type: "directional", direction: [-0.5, -0.8, -0.6] };
const kBall = { mesh: "primitive:sphere:24", material: kPaint };

export const kShading: Bench = {
  name: "shading",
  tab: "shading",
  scene: {
    image: { samples: 2 },
    shading: { recompute_normals: true },
    lights: [kSun],
    objects: [
      { mesh: "primitive:torus:10", material: kPaint },
      // seen from behind
      { mesh: "primitive:plane", material: kPaint, matrix: [1, 0, 0, 1.5, 0, -1, 0, 0.5, 0, 0, -1, 0, 0, 0, 0, 1] },
    ],
  },
  controls: [
    { key: "shading.lighting" },
    { key: "shading.interpolation" },
    { key: "shading.terms" },
    { key: "shading.normalized" },
    { key: "shading.normals" },
    { key: "shading.vertex_normals" },
    { key: "shading.crease", type: 30 },
    { key: "shading.recompute_normals" },
    { key: "shading.two_sided" },
    { key: "shading.cull" },
    { key: "image.samples" },
  ],
};

export const kCamera: Bench = {
  name: "camera",
  tab: "camera",
  scene: {
    image: { samples: 1 },
    camera: { eye: [0.3, 1, 4.2], target: [0, 0.1, 0] },
    objects: [kBall],
  },
  controls: [
    { key: "camera.projection" },
    { key: "camera.fov", type: 30 },
    { key: "camera.eye", type: 2 },
    { key: "camera.target", type: 0.2 },
    { key: "camera.up", type: 0.4 },
    { key: "camera.near", type: 3.6, slideBy: "Arrow" },
    { key: "camera.far", type: 4, slideBy: "Arrow" },
  ],
};

export const kParallel: Bench = {
  name: "a parallel camera",
  tab: "camera",
  scene: { image: { samples: 1 }, camera: { projection: "orthographic" }, objects: [kBall] },
  controls: [{ key: "camera.height", type: 3 }],
};

export const kSurroundings: Bench = {
  name: "surroundings",
  tab: "scene",
  scene: {
    image: { samples: 1, background: [0.2, 0.25, 0.3], width: 320, height: 240, tone: { operator: "none" } },
    lights: [kSun],
    fog: { mode: "exp2", density: 0.1, color: [0.5, 0.5, 0.6] },
    environment: { color: [0.2, 0.22, 0.26], visible: false },
    shadow: { size: 128, softness: 1 },
    occlusion: { directions: 8, size: 32 },
    ground: { strength: 0.7 },
    objects: [kBall, { mesh: "primitive:cube", material: kPaint, matrix: place(1.4, -0.6, 0.3, 0.5) }],
  },
  controls: [
    { key: "image.width", type: 300 },
    { key: "image.height", type: 200 },
    { key: "image.background" },
    { key: "image.transparent" },
    { key: "image.transfer" },
    { key: "image.tone.operator" },
    { key: "image.tone.exposure", type: 1.5 },
    { key: "shadow.size", type: 64 },
    { key: "shadow.softness", type: 4 },
    { key: "occlusion.directions", type: 16 },
    { key: "occlusion.size", type: 64 },
    { key: "occlusion.radius", type: 0.3 },
    { key: "ground.height", type: -1.5 },
    { key: "ground.strength", type: 0.4 },
    { key: "fog.mode" },
    { key: "fog.density", type: 0.2 },
    { key: "fog.color" },
    { key: "environment.color" },
    { key: "environment.gain", type: 0.5 },
    { key: "environment.visible" },
  ],
};

export const kHaze: Bench = {
  name: "haze under a sky",
  tab: "scene",
  pictures: ["checks.png"],
  scene: {
    image: { samples: 1 },
    fog: { mode: "linear", start: 0.5, end: 9, color: [0.5, 0.5, 0.6] },
    environment: { file: "checks.png" },
    objects: [kBall],
  },
  controls: [
    { key: "fog.start", type: 1 },
    { key: "fog.end", type: 6 },
    { key: "environment.rotation", type: 40 },
  ],
};

export const kLights: Bench = {
  name: "lights",
  tab: "lights",
  scene: {
    image: { samples: 1 },
    camera: { eye: [0.5, 2, 4.5], target: [0, 0, 0] },
    shadow: { size: 128 },
    lights: [
      { ...kSun, diffuse: [0.4, 0.4, 0.4] },
      { type: "point", position: [1.5, 1.2, 1.4], diffuse: [0.5, 0.4, 0.3], attenuation: { constant: 0.3, quadratic: 0.05 } },
      { type: "spot", position: [-1.5, 2.4, 1.5], direction: [0.5, -0.8, -0.5], cutoff: 30, beam: 15, diffuse: [0.4, 0.5, 0.6] },
      { type: "rectangle", position: [-2, 2, -1], direction: [0.6, -0.6, 0.3], size: [0.5, 0.5], diffuse: [0.5, 0.5, 0.5] },
      { type: "disk", position: [2, 2, -1], direction: [-0.6, -0.6, 0.3], radius: 0.3, diffuse: [0.5, 0.5, 0.5] },
    ],
    objects: [kBall, { mesh: "primitive:plane", material: kPaint, matrix: place(0, -1, 0, 2) }],
  },
  controls: [
    { key: "lights[].type", path: "lights[0].type" },
    { key: "lights[].name", path: "lights[0].name", unseen: true },
    { key: "lights[].direction", path: "lights[0].direction", type: -0.6 },
    { key: "lights[].diffuse", path: "lights[0].diffuse" },
    { key: "lights[].specular", path: "lights[0].specular" },
    { key: "lights[].ambient", path: "lights[0].ambient" },
    { key: "lights[].shadow", path: "lights[0].shadow" },
    { key: "lights[].position", path: "lights[1].position", type: 0.9 },
    { key: "lights[].attenuation.constant", path: "lights[1].attenuation.constant", type: 0.8 },
    { key: "lights[].attenuation.linear", path: "lights[1].attenuation.linear", type: 0.5 },
    { key: "lights[].attenuation.quadratic", path: "lights[1].attenuation.quadratic", type: 0.4 },
    { key: "lights[].attenuation.falloff", path: "lights[1].attenuation.falloff", type: 1.5 },
    { key: "lights[].attenuation.range", path: "lights[1].attenuation.range", type: 3 },
    { key: "lights[].attenuation.unclamped", path: "lights[1].attenuation.unclamped" },
    { key: "lights[].cutoff", path: "lights[2].cutoff", type: 50 },
    { key: "lights[].beam", path: "lights[2].beam", type: 5 },
    { key: "lights[].fade", path: "lights[2].fade" },
    { key: "lights[].exponent", path: "lights[2].exponent", type: 10 },
    { key: "lights[].size", path: "lights[3].size", type: 0.7 },
    { key: "lights[].x_axis", path: "lights[3].x_axis", type: 0.5, unseen: true },
    { key: "lights[].radius", path: "lights[4].radius", type: 0.4 },
    { key: "ambient" },
  ],
};

const inPaint = (key: string, more: Partial<Control> = {}): Control => ({
  key: `materials.*.${key}`,
  path: `objects[0].material.${key}`,
  ...more,
});

export const kMaterial: Bench = {
  name: "material",
  tab: "material",
  scene: {
    image: { samples: 1 },
    shading: { two_sided: true },
    lights: [kSun],
    objects: [{ mesh: "primitive:torus:16", material: { ...kPaint, opacity: 0.6 }, name: "ring" }],
  },
  controls: [
    inPaint("ambient"),
    inPaint("diffuse"),
    inPaint("specular"),
    inPaint("emission"),
    inPaint("shininess", { type: 60 }),
    inPaint("opacity", { type: 0.3 }),
    inPaint("alpha_mode", { alike: ["mask"] }),
    inPaint("lighting", { alike: ["phong"] }),
    inPaint("cull", { alike: ["none"] }),
    inPaint("illumination", { type: 5, unseen: true }),
    inPaint("refraction", { type: 1.5, unseen: true }),
    inPaint("transmission", { unseen: true }),
    inPaint("name", { unseen: true }),
    { key: "objects[].name", path: "objects[0].name", unseen: true },
    { key: "objects[].matrix", path: "objects[0].matrix" },
  ],
};

export const kMask: Bench = {
  name: "a masked material",
  tab: "material",
  scene: {
    image: { samples: 1 },
    materials: { veil: { ...kPaint, opacity: 0.6, alpha_mode: "mask" } },
    objects: [{ mesh: "primitive:torus:16", material: "veil" }],
  },
  controls: [{ key: "materials.*.alpha_cutoff", path: "materials.veil.alpha_cutoff", type: 0.85 }],
};

const inMap = (key: string, more: Partial<Control> = {}): Control => ({
  key: `materials.*.textures.*.${key}`,
  path: `objects[0].material.textures.diffuse.${key}`,
  ...more,
});

const textured = (texture: object): SceneDoc => ({
  image: { samples: 1 },
  objects: [{ mesh: "primitive:plane", material: { textures: { diffuse: { file: "checks.png", ...texture } } } }],
});

export const kTexture: Bench = {
  name: "a texture near by",
  tab: "material",
  pictures: ["checks.png"],
  scene: textured({ scale: [1.7, 1.3] }),
  controls: [
    inMap("scale", { type: 2 }),
    inMap("offset", { type: 0.2 }),
    inMap("rotation", { type: 30 }),
    inMap("wrap"),
    inMap("magnify"),
    inMap("gain", { type: 0.5 }),
    inMap("base", { type: 0.2 }),
    inMap("v_down"),
    inMap("uv_set", { type: 1 }),
    inMap("matrix"),
  ],
};

export const kFineTexture: Bench = {
  name: "a texture far away",
  tab: "material",
  pictures: ["checks.png"],
  scene: textured({ scale: [30, 30] }),
  controls: [inMap("minify"), inMap("mip"), inMap("anisotropy", { type: 8 }), inMap("lod_bias", { type: 2 })],
};

export const kEdges: Bench = {
  name: "a texture with a border",
  tab: "material",
  pictures: ["checks.png"],
  scene: textured({ scale: [1.7, 1.3], wrap: "clamp_to_border", border: [0.1, 0.2, 0.3] }),
  controls: [inMap("border"), inMap("once")],
};

export const kNormalMap: Bench = {
  name: "a map of normals",
  tab: "material",
  pictures: ["checks.png"],
  scene: {
    image: { samples: 1 },
    objects: [{ mesh: "primitive:sphere:24", material: { ...kPaint, textures: { normal: "checks.png" } } }],
  },
  controls: [{ key: "materials.*.textures.object_space", path: "objects[0].material.textures.object_space" }],
};

export const kDataMap: Bench = {
  name: "a texture of numbers",
  tab: "material",
  pictures: ["checks.png"],
  scene: {
    image: { samples: 1 },
    objects: [{ mesh: "primitive:plane", material: { textures: { opacity: { file: "checks.png" } } } }],
  },
  controls: [{ ...inMap("channel", { alike: ["auto"] }), path: "objects[0].material.textures.opacity.channel" }],
};

const kMaps = ["ambient", "diffuse", "specular", "emission", "shininess", "opacity", "decal", "bump", "normal", "displacement"];
const kSides = ["right", "left", "top", "bottom", "front", "back"];
const of = (test: string, keys: readonly string[]) => Object.fromEntries(keys.map((key) => [key, test]));

/** Keys whose controls are no single row, and the tests that operate them. */
export const kByThemselves: Readonly<Record<string, string>> = {
  ...of("parts that are there or not", ["fog", "environment", "shadow", "occlusion", "ground"]),
  ...of("the sky's picture", ["environment.file"]),
  ...of("the views", ["camera.view"]),
  ...of("lights are added, copied and removed", ["lights"]),
  ...of("the library's materials", ["objects[].material"]),
  ...of("a material of the scene is changed where it stands", ["materials"]),
  ...of("objects are added, copied, shaped and removed", ["objects", "objects[].mesh"]),
  ...of("what pictures drive", ["materials.*.textures", "materials.*.textures.*.file"]),
  ...of(
    "what pictures drive",
    kMaps.map((map) => `materials.*.textures.${map}`),
  ),
  ...of("what a surface mirrors", ["materials.*.textures.reflection"]),
  ...of(
    "what a surface mirrors",
    ["shape", "picture", ...kSides].map((key) => `materials.*.textures.reflection.${key}`),
  ),
};

/** Tables whose keys are tested one by one. */
export const kTables = ["image", "camera", "shading", "image.tone", "lights[].attenuation"];

export const kBenches = {
  shading: [kShading, kCamera, kParallel],
  surroundings: [kSurroundings, kHaze],
  lights: [kLights],
  materials: [kMaterial, kMask],
  textures: [kTexture, kFineTexture, kEdges, kDataMap, kNormalMap],
};
