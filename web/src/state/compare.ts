// Two pictures beside each other: the engine's and the GPU's, or two settings of the same scene. src/gpu draws them; the lessons set this, too.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import type { SceneDoc } from "../engine/types";
import { withValue, type Path } from "./path";
import { scene } from "./scene";

/** What one side has that the scene does not: `[["shading.interpolation", "flat"]]`. */
export type Changes = readonly (readonly [Path, unknown])[];

export type Comparison =
  | { kind: "none" }
  /** the engine's picture and WebGL's: one of them, both with a wipe, or their difference enlarged */
  | { kind: "gpu"; show: "gpu" | "wipe" | "difference"; gain: 1 | 8 | 64 }
  /** the scene with some changes at the left, with others at the right */
  | { kind: "settings"; left: Changes; right: Changes };

export const comparison = signal<Comparison>({ kind: "none" });

/** Where the wipe stands, 0 at the left edge of the picture, 1 at the right one. */
export const wipe = signal(0.5);

function withChanges(doc: SceneDoc, changes: Changes): SceneDoc {
  return changes.reduce((changed, [path, value]) => withValue(changed, path, value), doc);
}

/** The scenes of the two sides; undefined where no settings are compared. */
export const comparedScenes: ReadonlySignal<{ left: SceneDoc; right: SceneDoc } | undefined> = computed(() => {
  const { value } = comparison;
  return value.kind === "settings"
    ? { left: withChanges(scene.value, value.left), right: withChanges(scene.value, value.right) }
    : undefined;
});
