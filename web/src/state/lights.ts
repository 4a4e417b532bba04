// The lights of the scene: the stated ones, or the default rig until it is taken over; adding, copying, removing, fixing to the camera.
import { computed, type ReadonlySignal } from "@preact/signals";
import type { LightInfo, Vec3, ViewInfo } from "../engine/types";
import { add, length, rounded, scaled, subtract } from "../stage/vector";
import { lightsShown, view } from "./picture";
import type { Path } from "./path";
import { at, attachedLights, editLab, scene } from "./scene";
import { selectedLight } from "./selection";

export type LightType = LightInfo["type"];
export type LightEntry = Record<string, unknown>;

const stated = at<LightEntry[]>("lights");

/** The scene states no lights: key, fill and rim move with the camera. */
export const isDefaultRig: ReadonlySignal<boolean> = computed(() => stated.value === undefined);

/** As a scene file states them. */
export const lights: ReadonlySignal<readonly LightEntry[]> = computed(() => stated.value ?? lightsShown.value.map((light) => light.stated));

export function typeOf(light: LightEntry | undefined): LightType {
  return (light?.["type"] as LightType | undefined) ?? "directional";
}

export const hasPosition = (type: LightType): boolean => type !== "directional";
export const hasDirection = (type: LightType): boolean => type !== "point" && type !== "sphere";
export const isArea = (type: LightType): boolean => type === "rectangle" || type === "disk" || type === "sphere";

const vector = (value: unknown, instead: Vec3): Vec3 =>
  Array.isArray(value) && value.length === 3 && value.every((x) => typeof x === "number") ? (value as unknown as Vec3) : instead;

export const positionOf = (light: LightEntry): Vec3 => vector(light["position"], [0, 0, 0]);
export const directionOf = (light: LightEntry): Vec3 => vector(light["direction"], [0, 0, -1]);

/** A change of the list of lights, and of those that are fixed to the camera. */
function change(next: (list: LightEntry[], attached: number[]) => { list: LightEntry[]; attached: number[] }): void {
  const before = [...lights.peek()];
  // The rig moves with the camera: so do its lights when they become the scene's.
  const attachedBefore = isDefaultRig.peek() ? before.map((_, i) => i) : [...attachedLights.peek()];
  const { list, attached } = next(before, attachedBefore);
  editLab((doc) => ({ scene: { ...doc.scene, lights: list }, attached }));
}

/** The default rig becomes lights of the scene; nothing changes to the eye. */
export function takeOverRig(): void {
  change((list, attached) => ({ list, attached }));
  selectedLight.value = 0;
}

/** Back to the default rig. */
export function backToRig(): void {
  editLab((doc) => {
    const { lights: _lights, ...others } = doc.scene;
    return { scene: others, attached: [] };
  });
  selectedLight.value = undefined;
}

/** A new light that shines on what the camera looks at, from above and beside it. */
export function newLight(type: LightType, v: ViewInfo | undefined): LightEntry {
  // Of a scene that goes far beyond what is looked at, what is looked at counts.
  const size = v ? Math.min(length(subtract(v.upper, v.lower)), 1.2 * length(subtract(v.eye, v.target))) || 1 : 1;
  const target: Vec3 = v?.target ?? [0, 0, 0];
  const [right, up, back] = v
    ? [v.right, v.up, scaled(v.forward, -1)]
    : ([
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ] as [Vec3, Vec3, Vec3]);
  const away = add(add(scaled(right, 0.45 * size), scaled(up, 0.5 * size)), scaled(back, 0.35 * size));
  const light: LightEntry = { type };
  if (hasPosition(type)) {
    light["position"] = rounded(add(target, away), size);
  }
  if (hasDirection(type)) {
    light["direction"] = rounded(scaled(away, -1 / (length(away) || 1)), 1);
  }
  const short = (value: number) => Number(value.toPrecision(2));
  switch (type) {
    case "spot":
      return { ...light, cutoff: 25, beam: 15 };
    case "rectangle":
      return { ...light, size: [short(0.3 * size), short(0.3 * size)], diffuse: [4, 4, 4] };
    case "disk":
      return { ...light, radius: short(0.18 * size), diffuse: [4, 4, 4] };
    case "sphere":
      return { ...light, radius: short(0.08 * size), diffuse: [10, 10, 10] };
    default:
      return light;
  }
}

export function addLight(type: LightType): void {
  change((list, attached) => ({ list: [...list, newLight(type, view.peek())], attached }));
  selectedLight.value = (scene.peek().lights?.length ?? 1) - 1;
}

export function duplicateLight(index: number): void {
  change((list, attached) => ({
    list: [...list.slice(0, index + 1), { ...list[index] }, ...list.slice(index + 1)],
    attached: [...attached.map((i) => (i > index ? i + 1 : i)), ...(attached.includes(index) ? [index + 1] : [])],
  }));
  selectedLight.value = index + 1;
}

export function removeLight(index: number): void {
  change((list, attached) => ({
    list: list.filter((_, i) => i !== index),
    attached: attached.filter((i) => i !== index).map((i) => (i > index ? i - 1 : i)),
  }));
  const left = scene.peek().lights?.length ?? 0;
  selectedLight.value = left === 0 ? undefined : Math.min(index, left - 1);
}

/** Fixed to the camera, or to the world. */
export function attachLight(index: number, isAttached: boolean): void {
  change((list, attached) => ({
    list,
    attached: isAttached ? [...attached.filter((i) => i !== index), index] : attached.filter((i) => i !== index),
  }));
}

/** Another kind, with what the new one needs; undefined: the default one. */
export function setLightType(index: number, type: LightType | undefined): void {
  const changed = (light: LightEntry): LightEntry => {
    const { type: _type, ...others } = light;
    const { type: kind, ...needed } = newLight(type ?? typeOf(undefined), view.peek());
    return { ...(type === undefined ? {} : { type: kind }), ...needed, ...others };
  };
  change((list, attached) => ({ list: list.map((light, i) => (i === index ? changed(light) : light)), attached }));
}

/** What states that a light fades by a power of the distance: the three factors have no place beside it. */
export function fadingByPower(index: number, power: unknown): [Path, unknown][] {
  const others = power === undefined ? [] : ["constant", "linear", "quadratic"];
  return [
    ...others.map((key): [Path, unknown] => [["lights", index, "attenuation", key], undefined]),
    [["lights", index, "attenuation", "falloff"], power],
  ];
}
