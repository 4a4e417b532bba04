// The objects of the scene and what they are made of: where the coefficients of an object's material stand, and how they are changed there.
import type { SceneDoc, SceneObject } from "../engine/types";
import { add, length, rounded, scaled, subtract } from "../stage/vector";
import { libraryMaterials } from "./engine";
import { meshes } from "./meshes";
import { isTable, type Path } from "./path";
import { view } from "./picture";
import { scene, update, updateAll } from "./scene";
import { selectedObject, selectObject } from "./selection";

export type Table = Record<string, unknown>;

export type MaterialSource =
  /** coefficients that the scene states: in the object, or by name in `materials` */
  | { kind: "stated"; path: Path; table: Table; name: string }
  /** of the library; the first change copies it to `path` */
  | { kind: "library"; path: Path; table: Table; name: string }
  /** of the mesh's file, or the library's default; the first change states one for the whole object */
  | { kind: "own"; path: Path; table: Table; names: readonly string[] };

function libraryTable(name: string): Table | undefined {
  return libraryMaterials.value.find((material) => material.name === name)?.table;
}

/** Where the coefficients of an object stand. */
export function materialOf(doc: SceneDoc, index: number): MaterialSource {
  const object = doc.objects[index];
  const here: Path = ["objects", index, "material"];
  const stated = object?.material;
  if (isTable(stated)) {
    return { kind: "stated", path: here, table: stated, name: typeof stated["name"] === "string" ? stated["name"] : "" };
  }
  if (typeof stated === "string") {
    const named = doc.materials?.[stated];
    if (isTable(named)) {
      return { kind: "stated", path: ["materials", stated], table: named, name: stated };
    }
    if (typeof named === "string") {
      return { kind: "library", path: ["materials", stated], table: libraryTable(named) ?? {}, name: named };
    }
    return { kind: "library", path: here, table: libraryTable(stated) ?? {}, name: stated };
  }
  const own = meshes.value[index]?.materials ?? [];
  return { kind: "own", path: here, table: own[0]?.table ?? {}, names: own.map(({ name }) => name) };
}

/** States one coefficient of an object's material; undefined: its default. */
export function setCoefficient(index: number, key: string, value: unknown): void {
  const source = materialOf(scene.peek(), index);
  if (source.kind === "stated") {
    update([...(source.path as readonly (string | number)[]), key], value);
    return;
  }
  const copy: Table = { ...source.table };
  if (value === undefined) {
    delete copy[key];
  } else {
    copy[key] = value;
  }
  update(source.path, copy);
}

/** Gives an object a library material, or (undefined) its mesh's own. */
export function setMaterial(index: number, name: string | undefined): void {
  const source = materialOf(scene.peek(), index);
  const isNamed = source.kind !== "own" && (source.path as readonly (string | number)[])[0] === "materials";
  // A name that other objects use, too, keeps its meaning: this object alone gets another material.
  update(
    isNamed && name !== undefined && usersOf(scene.peek().objects[index]?.material) === 1 ? source.path : ["objects", index, "material"],
    name,
  );
}

function usersOf(name: unknown): number {
  return scene.peek().objects.filter((object) => object.material === name).length;
}

/** What a list shows. */
export function objectLabel(object: SceneObject, index: number): string {
  if (object.name) {
    return object.name;
  }
  const file = object.mesh
    .replace(/^primitive:/, "")
    .split("/")
    .at(-1);
  return file || `${index + 1}`;
}

export interface Primitive {
  name: string;
  segments: number | undefined;
}

export const kPrimitives = ["sphere", "torus", "cube", "plane", "teapot"] as const;
const kOwnSegments: Record<string, number> = { sphere: 64, torus: 64, cube: 1, plane: 1 };

/** What `primitive:sphere:24` says; undefined for files. */
export function primitiveOf(mesh: string): Primitive | undefined {
  const parts = /^primitive:([a-z]+)(?::(\d+))?$/.exec(mesh);
  return parts ? { name: parts[1]!, segments: parts[2] === undefined ? kOwnSegments[parts[1]!] : Number(parts[2]) } : undefined;
}

export function primitiveMesh(name: string, segments: number | undefined): string {
  return segments === undefined || segments === kOwnSegments[name] ? `primitive:${name}` : `primitive:${name}:${segments}`;
}

/** A new object stands in sight: beside what the camera looks at, to its right. */
export function addObject(mesh: string): void {
  const { objects } = scene.peek();
  const v = view.peek();
  const entry: SceneObject = { mesh };
  if (v && objects.length > 0) {
    // Half of what is seen at the target's distance, from the middle to the right edge.
    const distance = v.projection === "perspective" ? length(subtract(v.eye, v.target)) : 1;
    const seen = (distance * v.width) / v.pixelsPerUnit / 2;
    const size = Number((Math.min(seen, (seen * v.height) / v.width) * 0.25).toPrecision(2));
    const [x, y, z] = rounded(add(v.target, scaled(v.right, seen * 0.6)), seen);
    entry["matrix"] = [size, 0, 0, x, 0, size, 0, y, 0, 0, size, z, 0, 0, 0, 1];
  }
  updateAll([["objects", [...objects, entry]]], "");
  selectObject(objects.length);
}

export function duplicateObject(index: number): void {
  const { objects } = scene.peek();
  const copy = objects[index];
  if (copy) {
    updateAll([["objects", [...objects.slice(0, index + 1), copy, ...objects.slice(index + 1)]]], "");
    selectObject(index + 1);
  }
}

export function removeObject(index: number): void {
  const { objects } = scene.peek();
  updateAll([["objects", objects.filter((_, i) => i !== index)]], "");
  selectObject(Math.max(0, Math.min(selectedObject.peek(), objects.length - 2)));
}
