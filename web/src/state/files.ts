// The files that are open: what the engine's meshes and textures were read from.
import { signal } from "@preact/signals";
import type { EngineFile } from "../engine/types";

export interface OpenedFiles {
  /** `none`: the scene needs no files. `served`: of `lustro lab`, reloaded when they change */
  source: "none" | "dropped" | "served";
  /** the model or scene that was opened */
  entry: string;
  files: readonly EngineFile[];
  /** of the entry, as a glTF file names them */
  cameras: readonly string[];
  animations: readonly string[];
}

export const kNoFiles: OpenedFiles = { source: "none", entry: "", files: [], cameras: [], animations: [] };

export const openedFiles = signal<OpenedFiles>(kNoFiles);

/** Something is being loaded: its name, and how far it is (0..1; undefined: unknown). */
export const loading = signal<{ what: string; share?: number } | undefined>(undefined);

/** The pictures among the files that are open. */
export function openedPictures(): readonly string[] {
  return openedFiles.value.files.map(({ path }) => path).filter((path) => /\.(png|jpe?g|webp|gif|exr|pfm|hdr)$/i.test(path));
}
