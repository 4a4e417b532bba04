// Scenes to begin with: of primitives alone, or with models that lie beside the page and are fetched when they are wanted.
import chessmen from "../../../examples/scenes/chessmen.json";
import gems from "../../../examples/scenes/gems.json";
import hero from "../../../examples/scenes/hero.json";
import mist from "../../../examples/scenes/mist.json";
import stage from "../../../examples/scenes/stage.json";
import cornell from "../../../examples/scenes/cornell.json";
import cornellMtl from "../../../assets/cornell_box/CornellBox-Original.mtl?url";
import cornellObj from "../../../assets/cornell_box/CornellBox-Original.obj?url";
import spotObj from "../../../assets/spot/spot_triangulated.obj?url";
import spotPng from "../../../assets/spot/spot_texture.png?url";
import type { EngineFile, SceneDoc } from "../engine/types";
import { fullSize } from "../state/picture";
import cornellPicture from "./examples/cornell.jpg?url";
import shadows from "./examples/shadows.json";
import spot from "./examples/spot.json";
import spotPicture from "./examples/spot.jpg?url";
import stagePicture from "./examples/stage.jpg?url";
import start from "./examples/start.json";
import threeWays from "./examples/three-ways.json";

export const kStartScene = start as SceneDoc;

export type ExampleName = "start" | "threeWays" | "gems" | "shadows" | "mist" | "chessmen" | "hero" | "stage" | "spot" | "cornell";

export interface Example {
  name: ExampleName;
  scene: SceneDoc;
  /** what has to be fetched, by path */
  files?: Readonly<Record<string, string>>;
  /** where the scene itself stands among them */
  entry?: string;
  /** its small picture, where the scene alone draws none: `npm run pictures` */
  picture?: string;
}

export const kExamples: readonly Example[] = [
  { name: "start", scene: kStartScene },
  { name: "threeWays", scene: threeWays as SceneDoc },
  { name: "gems", scene: gems as SceneDoc },
  { name: "shadows", scene: shadows as SceneDoc },
  {
    name: "spot",
    scene: spot as SceneDoc,
    entry: "scene.json",
    picture: spotPicture,
    files: { "spot_triangulated.obj": spotObj, "spot_texture.png": spotPng },
  },
  {
    name: "stage",
    scene: stage as SceneDoc,
    entry: "examples/scenes/stage.json",
    picture: stagePicture,
    files: { "assets/spot/spot_triangulated.obj": spotObj },
  },
  { name: "mist", scene: mist as SceneDoc },
  {
    name: "cornell",
    scene: cornell as SceneDoc,
    entry: "examples/scenes/cornell.json",
    picture: cornellPicture,
    files: { "assets/cornell_box/CornellBox-Original.obj": cornellObj, "assets/cornell_box/CornellBox-Original.mtl": cornellMtl },
  },
  { name: "chessmen", scene: chessmen as SceneDoc },
  { name: "hero", scene: hero as SceneDoc },
];

/**
 * The scene without a size of its own: it fills the window. Where that is narrower than the picture that the scene was made for, the angle of view
 * grows, so that nothing is cut off at the sides.
 */
export function forWindow(scene: SceneDoc, aspect = fullSize.peek().width / (fullSize.peek().height || 1)): SceneDoc {
  const { width, height, ...image } = scene.image ?? {};
  const made = typeof width === "number" && typeof height === "number" ? width / height : 4 / 3;
  const camera = scene.camera ?? {};
  const narrower = aspect > 0 ? Math.max(1, made / aspect) : 1;
  if (narrower === 1 || camera["eye"] === undefined) {
    return { ...scene, image };
  }
  if (typeof camera["height"] === "number") {
    return { ...scene, image, camera: { ...camera, height: Number((camera["height"] * narrower).toPrecision(4)) } };
  }
  const half = ((typeof camera["fov"] === "number" ? camera["fov"] : 42) * Math.PI) / 360;
  const fov = Number(((Math.atan(Math.tan(half) * narrower) * 360) / Math.PI).toPrecision(4));
  return { ...scene, image, camera: { ...camera, fov } };
}

export async function fetchExample(example: Example): Promise<EngineFile[]> {
  const files: EngineFile[] = [];
  for (const [path, url] of Object.entries(example.files ?? {})) {
    const answer = await fetch(url);
    if (!answer.ok) {
      throw new Error(`${path}: ${answer.status} ${answer.statusText}`);
    }
    files.push({ path, bytes: new Uint8Array(await answer.arrayBuffer()) });
  }
  return [...files, { path: example.entry ?? "scene.json", bytes: new TextEncoder().encode(JSON.stringify(forWindow(example.scene))) }];
}
