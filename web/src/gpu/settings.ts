// The pairs of settings that are worth a look, and what a side is called.
import type { SceneDoc } from "../engine/types";
import type { Changes } from "../state/compare";
import { pathText, valueAt } from "../state/path";

export interface Pair {
  id: string;
  /** words of the scene file, the same in every language */
  name: string;
  left: Changes;
  right: Changes;
}

const interpolation = (word: string): Changes => [["shading.interpolation", word]];
const lighting = (word: string): Changes => [["shading.lighting", word]];
const terms = (...words: string[]): Changes => [["shading.terms", words]];

export const kPairs: readonly Pair[] = [
  { id: "flat-gouraud", name: "flat | gouraud", left: interpolation("flat"), right: interpolation("gouraud") },
  { id: "gouraud-phong", name: "gouraud | phong", left: interpolation("gouraud"), right: interpolation("phong") },
  { id: "flat-phong", name: "flat | phong", left: interpolation("flat"), right: interpolation("phong") },
  { id: "phong-blinn", name: "phong | blinn-phong", left: lighting("phong"), right: lighting("blinn-phong") },
  { id: "lambert-phong", name: "lambert | phong", left: lighting("lambert"), right: lighting("phong") },
  {
    id: "specular",
    name: "− specular | + specular",
    left: terms("ambient", "diffuse", "emission"),
    right: terms("ambient", "diffuse", "specular", "emission"),
  },
  {
    id: "ambient",
    name: "− ambient | + ambient",
    left: terms("diffuse", "specular", "emission"),
    right: terms("ambient", "diffuse", "specular", "emission"),
  },
  { id: "lerp-slerp", name: "lerp | slerp", left: [["shading.normals", "lerp"]], right: [["shading.normals", "slerp"]] },
  { id: "shadow", name: "− shadow | + shadow", left: [["shadow", false]], right: [["shadow", true]] },
];

/** What a side has that the other has not, in a few words. Where only the other one is changed, it is what the scene says there. */
export function sideLabel(scene: SceneDoc, own: Changes, other: Changes): string {
  const isOwn = new Set(own.map(([path]) => pathText(path)));
  const plain = other
    .map(([path]) => [path, valueAt(scene, path)] as const)
    .filter(([path, value]) => !isOwn.has(pathText(path)) && value !== undefined);
  const text = [...own, ...plain].map(([path, value]) => {
    const key = pathText(path).split(".").at(-1)!;
    if (Array.isArray(value)) {
      const others = other.find(([place]) => pathText(place) === pathText(path))?.[1];
      const more = Array.isArray(others) ? value.filter((word) => !others.includes(word)) : [];
      const less = Array.isArray(others) ? others.filter((word) => !value.includes(word)) : [];
      return [...more.map((word) => `+ ${word}`), ...less.map((word) => `− ${word}`)].join(" ");
    }
    if (typeof value === "boolean") {
      return `${value ? "+" : "−"} ${key}`;
    }
    return String(value ?? valueAt(scene, path) ?? key);
  });
  return text.join(", ");
}
