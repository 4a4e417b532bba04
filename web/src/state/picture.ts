// The latest picture of the engine, and what the page knows by it: the view, the lights, what the time was spent on.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import type { LightInfo, Picture, RenderRequest, ViewInfo } from "../engine/types";
import { openedFiles } from "./files";
import { scene } from "./scene";

/** What the stage shows; undefined until the first one is there. */
export const picture = signal<Picture | undefined>(undefined);

/** The picture is as large and as finely sampled as it shall be; false for the quick ones of a drag. */
export const isPictureFinal = signal(false);

/** A request is with the engine. */
export const isDrawing = signal(false);

/** The size of the full picture in its pixels: what the stage has room for, or what the scene states. Set by the stage. */
export const fullSize = signal<{ width: number; height: number }>({ width: 0, height: 0 });

export const view: ReadonlySignal<ViewInfo | undefined> = computed(() => picture.value?.view);
export const lightsShown: ReadonlySignal<readonly LightInfo[]> = computed(() => picture.value?.lights ?? []);

/** What asks the engine for the very picture that the stage shows at rest: for explain(), gpuScene(), exports. */
export const fullRequest: ReadonlySignal<RenderRequest> = computed(() => {
  // Newer files are another picture, though the scene says the same.
  void openedFiles.value;
  return { scene: scene.value, ...fullSize.value };
});
