// The engine as the page's signals: whether it runs, its table of options, its library of materials.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import type { EngineSetup } from "../engine/client";
import type { Engine, EngineInfo, Option, OptionGroup } from "../engine/types";
import { errorText, say } from "./messages";

export type EngineStatus = "starting" | "ready" | "failed";

export interface LibraryMaterial {
  name: string;
  table: Record<string, unknown>;
}

export const engine = signal<Engine | undefined>(undefined);
export const engineStatus = signal<EngineStatus>("starting");
export const optionGroups = signal<readonly OptionGroup[]>([]);
export const libraryMaterials = signal<readonly LibraryMaterial[]>([]);

/** How the engine runs; it changes while further workers join. */
export const engineInfo = signal<EngineInfo | undefined>(undefined);

/** The table of options by `shading.lighting`, `lights[].type`, `materials.*.diffuse`. */
export const options: ReadonlySignal<ReadonlyMap<string, Option>> = computed(() => {
  const all = new Map<string, Option>();
  for (const group of optionGroups.value) {
    for (const option of group.options) {
      all.set(group.path === "" ? option.key : `${group.path}.${option.key}`, option);
    }
  }
  return all;
});

/** Starts the engine and asks what it offers. */
export async function startEngine(create: (setup: EngineSetup) => Promise<Engine>): Promise<void> {
  try {
    const started = await create({ onInfo: (info) => (engineInfo.value = info) });
    const [groups, materials] = await Promise.all([started.options(), started.materials()]);
    optionGroups.value = groups;
    libraryMaterials.value = materials;
    engine.value = started;
    engineStatus.value = "ready";
  } catch (problem) {
    engineStatus.value = "failed";
    say("error", errorText(problem), "engine");
  }
}
