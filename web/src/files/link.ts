// A link that restores everything that the page's scene states, and what is compared and chosen: JSON, deflated, in the address' fragment (which no server sees). Files that were
// opened do not travel in it; their names do, so that the page can ask for them.
import { deflateSync, Inflate, strFromU8, strToU8 } from "fflate";
import type { SceneDoc } from "../engine/types";
import { isTable } from "../state/path";
import type { LabDoc } from "../state/scene";
import { readSight, type Sight } from "./sight";

const kPrefix = "#s=";
/** A link that unpacks to more is none of ours. */
const kMostBytes = 8 << 20;

export interface LinkContent extends LabDoc {
  /** the files that the scene needs, by their paths; empty where it needs none */
  files: readonly string[];
  sight?: Sight;
}

function toBase64Url(bytes: Uint8Array): string {
  let text = "";
  for (let at = 0; at < bytes.length; at += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  }
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromBase64Url(text: string): Uint8Array {
  return Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (char) => char.charCodeAt(0));
}

/** Unpacked, as long as it is not larger than a scene can reasonably be. */
function inflate(bytes: Uint8Array): Uint8Array {
  const parts: Uint8Array[] = [];
  let size = 0;
  const stream = new Inflate((part) => {
    size += part.length;
    if (size > kMostBytes) {
      throw new Error("the link unpacks to too much");
    }
    parts.push(part);
  });
  for (let at = 0; at < bytes.length; at += 4096) {
    stream.push(bytes.subarray(at, at + 4096), at + 4096 >= bytes.length);
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** `#s=...` */
export function linkHash({ scene, attached, files, sight = {} }: LinkContent): string {
  const content = {
    scene,
    ...(attached.length > 0 ? { attached } : {}),
    ...(files.length > 0 ? { files } : {}),
    ...(Object.keys(sight).length > 0 ? { sight } : {}),
  };
  return kPrefix + toBase64Url(deflateSync(strToU8(JSON.stringify(content)), { level: 9 }));
}

/** undefined: the fragment is no link of ours; throws where it is one that is damaged. */
export function readLink(hash: string): LinkContent | undefined {
  if (!hash.startsWith(kPrefix)) {
    return undefined;
  }
  const content: unknown = JSON.parse(strFromU8(inflate(fromBase64Url(hash.slice(kPrefix.length)))));
  const scene = isTable(content) ? content["scene"] : undefined;
  if (!isTable(content) || !isTable(scene) || !Array.isArray(scene["objects"]) || !scene["objects"].every(isTable)) {
    throw new Error("the link holds no scene");
  }
  const numbers = Array.isArray(content["attached"])
    ? content["attached"].filter((n): n is number => Number.isInteger(n) && (n as number) >= 0)
    : [];
  const names = Array.isArray(content["files"]) ? content["files"].filter((n): n is string => typeof n === "string") : [];
  const sight = readSight(content["sight"]);
  return {
    scene: scene as unknown as SceneDoc,
    attached: numbers,
    files: names,
    ...(Object.keys(sight).length > 0 ? { sight } : {}),
  };
}

/** Of a texture, and of a reflection's tables of textures. */
const kFileKeys = ["file", "picture", "right", "left", "top", "bottom", "front", "back"] as const;

function addTexture(found: Set<string>, texture: unknown): void {
  if (typeof texture === "string" && texture !== "") {
    found.add(texture);
  } else if (isTable(texture)) {
    kFileKeys.forEach((key) => addTexture(found, texture[key]));
  }
}

/** The paths that a scene names: meshes, textures, the sky. */
export function filesOf(scene: SceneDoc): string[] {
  const found = new Set<string>();
  for (const { mesh } of scene.objects) {
    if (typeof mesh === "string" && !mesh.startsWith("primitive:")) {
      found.add(mesh.replace(/#.*$/, ""));
    }
  }
  for (const material of [...Object.values(scene.materials ?? {}), ...scene.objects.map((object) => object.material)]) {
    if (isTable(material) && isTable(material["textures"])) {
      Object.values(material["textures"]).forEach((texture) => addTexture(found, texture));
    }
  }
  const sky = scene["environment"];
  addTexture(found, isTable(sky) ? sky["file"] : undefined);
  return [...found];
}
