// Small pictures of the library materials, the lighting models and the interpolations, drawn by the engine itself, once.
import { signal } from "@preact/signals";
import type { Engine, SceneDoc, Vec3 } from "../engine/types";
import type { LibraryMaterial } from "../state/engine";

export interface Thumbnail {
  width: number;
  height: number;
  bytes: Uint8ClampedArray<ArrayBuffer>;
}

/** By `material/gold`, `lighting/phong`, `interpolation/flat`. */
export const thumbnails = signal<Readonly<Record<string, Thumbnail>>>({});

const kSide = 96;
const kColumns = 6;

const kLights = [
  { type: "directional", direction: [-0.55, -0.7, -0.85], diffuse: [0.95, 0.93, 0.88], specular: [1, 1, 1] },
  { type: "directional", direction: [0.9, 0.1, -0.15], diffuse: [0.12, 0.15, 0.22], specular: [0.1, 0.12, 0.16] },
];

/** Balls on a grid of cells two units wide, seen in parallel; nothing behind them. */
function sheet(
  balls: readonly { material: unknown; segments: number }[],
  shading: Record<string, unknown>,
): { scene: SceneDoc; rows: number } {
  const rows = Math.ceil(balls.length / kColumns);
  const columns = Math.min(kColumns, balls.length);
  const center: Vec3 = [columns - 1, -(rows - 1), 0];
  return {
    rows,
    scene: {
      image: { transparent: true, samples: 8 },
      camera: { projection: "orthographic", eye: [center[0], center[1], 10], target: center, height: rows * 2, near: 1, far: 20 },
      shading,
      ambient: [0.3, 0.3, 0.3],
      lights: kLights,
      objects: balls.map(({ material, segments }, i) => ({
        mesh: `primitive:sphere:${segments}`,
        material: material as string,
        matrix: [0.92, 0, 0, 2 * (i % kColumns), 0, 0.92, 0, -2 * Math.floor(i / kColumns), 0, 0, 0.92, 0, 0, 0, 0, 1],
      })),
    },
  };
}

function cut(whole: { width: number; bytes: Uint8ClampedArray }, column: number, row: number): Thumbnail {
  const bytes = new Uint8ClampedArray(kSide * kSide * 4);
  for (let y = 0; y < kSide; y++) {
    const from = ((row * kSide + y) * whole.width + column * kSide) * 4;
    bytes.set(whole.bytes.subarray(from, from + kSide * 4), y * kSide * 4);
  }
  return { width: kSide, height: kSide, bytes };
}

const kClay = { ambient: "#7a4b20", diffuse: "#b5702c", specular: [0.55, 0.5, 0.42], shininess: 24 };

/** Draws all of them. */
export async function drawThumbnails(engine: Engine, materials: readonly LibraryMaterial[]): Promise<void> {
  const drawn: Record<string, Thumbnail> = {};
  const draw = async (names: readonly string[], balls: Parameters<typeof sheet>[0], shading: Record<string, unknown>) => {
    const { scene, rows } = sheet(balls, shading);
    const columns = Math.min(kColumns, balls.length);
    const picture = await engine.render({ scene, width: columns * kSide, height: rows * kSide, aside: true }, true);
    names.forEach((name, i) => (drawn[name] = cut(picture, i % kColumns, Math.floor(i / kColumns))));
  };
  await draw(
    materials.map(({ name }) => `material/${name}`),
    materials.map(({ name }) => ({ material: name, segments: 48 })),
    { lighting: "blinn-phong" },
  );
  const models = ["constant", "lambert", "phong", "blinn-phong", "ggx"];
  await draw(
    models.map((name) => `lighting/${name}`),
    models.map((lighting) => ({ material: { ...kClay, lighting }, segments: 48 })),
    {},
  );
  for (const interpolation of ["flat", "gouraud", "phong"]) {
    await draw([`interpolation/${interpolation}`], [{ material: kClay, segments: 7 }], { interpolation });
  }
  thumbnails.value = drawn;
}
