// What is chosen: an object, a light, a pixel and what the engine says of it.
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Explanation, SceneObject } from "../engine/types";
import { scene } from "./scene";

/** A pixel of the full picture (state/picture.ts: fullSize), counted from its upper left corner. */
export interface PixelPlace {
  x: number;
  y: number;
}

/** Chosen by a click or by keys on the stage; stays while the scene changes. */
export const selectedPixel = signal<PixelPlace | undefined>(undefined);

/** Under the pointer. */
export const hoveredPixel = signal<PixelPlace | undefined>(undefined);

/** Of the selected pixel; undefined while it is asked for. Written by src/explain. */
export const explanation = signal<Explanation | undefined>(undefined);

const object = signal(0);

/** Index into the scene's objects; always one that is there (0 where there is none). */
export const selectedObject: ReadonlySignal<number> = computed(() => Math.min(object.value, Math.max(0, scene.value.objects.length - 1)));
export const selectedObjectEntry: ReadonlySignal<SceneObject | undefined> = computed(() => scene.value.objects[selectedObject.value]);

export function selectObject(index: number): void {
  object.value = index;
}

// The object whose pixel is read is the one that is worked on.
effect(() => {
  const shown = explanation.value?.fragments[0]?.object;
  if (shown !== undefined) {
    object.value = shown;
  }
});

/** Index into the scene's lights, or into the default rig where the scene states none. */
export const selectedLight = signal<number | undefined>(undefined);
