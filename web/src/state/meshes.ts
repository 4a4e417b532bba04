// What the objects' meshes are: asked of the engine when the objects or what shapes their normals has changed, and nothing is being dragged.
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { MeshInfo } from "../engine/types";
import { engine } from "./engine";
import { openedFiles } from "./files";
import { isDragging, scene } from "./scene";

const list = signal<readonly MeshInfo[]>([]);

/** One an object, in their order; empty until the engine has answered. */
export const meshes: ReadonlySignal<readonly MeshInfo[]> = list;

const shapes = computed(() => JSON.stringify([scene.value.objects, scene.value.shading ?? {}]));

/** Begins to ask; the function that it returns ends that. */
export function followMeshes(): () => void {
  let asked = 0;
  return effect(() => {
    const current = engine.value;
    void shapes.value;
    void openedFiles.value;
    if (!current || isDragging.value) {
      return;
    }
    const mine = ++asked;
    current.meshes(scene.peek()).then(
      (answer) => {
        if (mine === asked) {
          list.value = answer;
        }
      },
      // A scene that cannot be loaded: the picture's message says why.
      () => {
        if (mine === asked) {
          list.value = [];
        }
      },
    );
  });
}
