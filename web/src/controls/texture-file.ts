// The picture of a texture: a texture is stated as its path alone, or as a table that says more.
import { isTable } from "../state/path";

export function textureFile(texture: unknown): string {
  return typeof texture === "string" ? texture : isTable(texture) && typeof texture["file"] === "string" ? texture["file"] : "";
}

/** The same texture with another picture. */
export function withFile(texture: unknown, path: string): unknown {
  return isTable(texture) ? { ...texture, file: path } : path;
}
