// Where answers are checked: the learner's scene, the scene as the step began, the pixel that was chosen, and an engine to ask. Pictures for
// checks are small and have one size everywhere, so that a lesson asks the same on a phone and on a projector.
import type {
  Engine,
  Explanation,
  FragmentExplanation,
  LightExplanation,
  Picture,
  RenderRequest,
  SceneDoc,
  ShadingExplanation,
  Vec3,
} from "../engine/types";
import { worldToPixel } from "../stage/projection";
import { add, cross, dot, length, scaled, subtract, unit } from "../stage/vector";
import type { Changes } from "../state/compare";
import { withValue } from "../state/path";

const kSize = { width: 240, height: 180 };
/** A pixel shows a place when it shows something this near to it, as a share of the distance from the eye. */
const kNear = 0.04;

export type BenchEngine = Pick<Engine, "render" | "explain">;

export interface PickedPixel {
  request: RenderRequest;
  x: number;
  y: number;
}

/** What a pixel says, with what most checks ask for at hand. */
export interface Reading {
  explanation: Explanation;
  fragment: FragmentExplanation;
  /** the evaluation that weighs most: the only one unless the interpolation is gouraud */
  shading: ShadingExplanation;
  /** of `shading`; the first light where there are several */
  light: LightExplanation | undefined;
}

export const degrees = (radians: number): number => (radians * 180) / Math.PI;

export function angleBetween(a: Vec3, b: Vec3): number {
  return degrees(Math.acos(Math.max(-1, Math.min(1, dot(unit(a), unit(b))))));
}

export const arcCosine = (cosine: number): number => degrees(Math.acos(Math.max(-1, Math.min(1, cosine))));

export function changed(scene: SceneDoc, changes: Changes): SceneDoc {
  return changes.reduce((doc, [path, value]) => withValue(doc, path, value), scene);
}

function readingOf(explanation: Explanation): Reading | undefined {
  const fragment = explanation.fragments[0];
  const shading = fragment?.shadings.reduce((most, other) => (other.weight > most.weight ? other : most));
  return fragment && shading ? { explanation, fragment, shading, light: shading.lights[0] } : undefined;
}

/** The normal of the triangle itself, turned to the side that is seen. */
export function faceNormal(reading: Reading): Vec3 {
  const [a, b, c] = reading.explanation.triangle!.positions;
  const normal = unit(cross(subtract(b, a), subtract(c, a)));
  return dot(normal, reading.shading.to_eye) < 0 ? [-normal[0], -normal[1], -normal[2]] : normal;
}

export class Bench {
  private drawn: Promise<Picture> | undefined;

  constructor(
    private readonly engine: BenchEngine,
    readonly scene: SceneDoc,
    /** as the step began */
    private readonly start: SceneDoc = scene,
    private readonly pixel?: PickedPixel,
  ) {}

  with(changes: Changes): Bench {
    return new Bench(this.engine, changed(this.scene, changes), this.start);
  }

  /** The step's beginning. */
  before(): Bench {
    return new Bench(this.engine, this.start);
  }

  private request(): RenderRequest {
    return { scene: this.scene, ...kSize, samples: 1 };
  }

  picture(): Promise<Picture> {
    this.drawn ??= this.engine.render({ ...this.request(), floats: true, hash: true }, true);
    return this.drawn;
  }

  /** The pixel of picture(). */
  async pixelOf(point: Vec3): Promise<{ x: number; y: number } | undefined> {
    const { view } = await this.picture();
    const place = worldToPixel(view, point);
    const x = Math.floor(place?.x ?? -1);
    const y = Math.floor(place?.y ?? -1);
    return x >= 0 && y >= 0 && x < kSize.width && y < kSize.height ? { x, y } : undefined;
  }

  /** What the surface says at a pixel of picture(); undefined over the background. */
  async readPixel(x: number, y: number): Promise<Reading | undefined> {
    return readingOf(await this.engine.explain(this.request(), x, y));
  }

  /** What the surface says at a place of the world; undefined where something else, or nothing, is seen there. */
  async at(point: Vec3): Promise<Reading | undefined> {
    const place = await this.pixelOf(point);
    const reading = place && (await this.readPixel(place.x, place.y));
    if (!reading) {
      return undefined;
    }
    const { eye } = (await this.picture()).view;
    return length(subtract(reading.fragment.position, point)) <= kNear * length(subtract(eye, point)) ? reading : undefined;
  }

  /** What the chosen pixel says; undefined where none is, or the background. */
  async picked(): Promise<Reading | undefined> {
    return this.pixel && readingOf(await this.engine.explain(this.pixel.request, this.pixel.x, this.pixel.y));
  }

  hasPicked(): boolean {
    return this.pixel !== undefined;
  }
}

/** The highlights alone, on black, lit at every pixel as they are now. */
export function highlightsOf(bench: Bench): Bench {
  return bench.with([
    ["shading.terms", ["specular"]],
    ["image.background", [0, 0, 0]],
  ]);
}

/** The largest value of any channel, and where. */
export function brightest(picture: Picture): { value: number; x: number; y: number } {
  const floats = picture.floats!;
  let best = { value: -1, x: 0, y: 0 };
  for (let i = 0; i < floats.length; ++i) {
    if (i % 4 !== 3 && floats[i]! > best.value) {
      const pixel = i >> 2;
      best = { value: floats[i]!, x: pixel % picture.width, y: Math.floor(pixel / picture.width) };
    }
  }
  return best;
}

/** How strong the strongest highlight is: 0 where there is none. */
export async function highlightPeak(bench: Bench): Promise<number> {
  return brightest(await highlightsOf(bench).picture()).value;
}

/** The share of what is drawn where the highlight has more than half of the strength that it can have, k_s. */
export async function highlightShare(bench: Bench, strength: number): Promise<number> {
  const picture = await highlightsOf(bench).picture();
  const floats = picture.floats!;
  let pixels = 0;
  for (let i = 0; i < floats.length; i += 4) {
    pixels += floats[i]! > strength / 2 ? 1 : 0;
  }
  return pixels / Math.max(1, picture.pixelsCovered);
}

/** The place in the world where the highlight is brightest. */
export async function highlightPlace(bench: Bench): Promise<Vec3> {
  const { x, y } = brightest(await highlightsOf(bench).picture());
  const reading = await bench.readPixel(x, y);
  return reading!.fragment.position;
}

/** Of a ball of radius 1 around the origin: the place whose normal is so many degrees from the first light, towards the side that is seen. */
export async function placeOnBall(bench: Bench, degreesFromLight: number): Promise<Vec3> {
  const { lights, view } = await bench.picture();
  const light = unit(scaled(lights[0]!.direction, -1));
  const eye = unit(view.eye);
  const across = unit(subtract(eye, scaled(light, dot(eye, light))));
  const angle = (degreesFromLight * Math.PI) / 180;
  return add(scaled(light, Math.cos(angle)), scaled(across, Math.sin(angle)));
}

/** Degrees by which the camera looks another way than when the step began. */
export async function cameraTurn(bench: Bench): Promise<number> {
  const [now, before] = await Promise.all([bench.picture(), bench.before().picture()]);
  return angleBetween(now.view.forward, before.view.forward);
}

/** For feedback: `0.42`, `12`. */
export const shown = (value: number, digits = 2): string => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");
/** With the comma of Italian. */
export const shownItalian = (value: number, digits = 2): string => shown(value, digits).replace(".", ",");
