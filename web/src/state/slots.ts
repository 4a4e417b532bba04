// Places of the page where other folders put what they make (src/gpu, src/explain, src/tour): they register components, the layout shows them.
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";

export interface SlotEntry {
  /** unique in its slot */
  id: string;
  /** entries are shown from low to high; overlays: low ones first, so high ones lie above */
  order: number;
  component: ComponentType;
}

export type SlotName =
  /** SVG content above the picture, in the stage's CSS pixels: see stage/projection.ts for world -> pixel */
  | "overlay"
  /** HTML that lies over the picture, as large as it is (position: absolute; inset: 0): the GPU's canvas, the wipe */
  | "layer"
  /** buttons of the stage's toolbar */
  | "stageTool"
  /** the explanation of the selected pixel, in the Explain panel */
  | "explain"
  /** buttons of the page's header */
  | "header"
  /** what floats over the whole page: dialogs, the card of a lesson */
  | "floating";

const registry = signal<Readonly<Partial<Record<SlotName, readonly SlotEntry[]>>>>({});

/** Puts a component into a slot; the function that it returns takes it out again. */
export function register(slot: SlotName, entry: SlotEntry): () => void {
  const others = (registry.peek()[slot] ?? []).filter((other) => other.id !== entry.id);
  registry.value = { ...registry.peek(), [slot]: [...others, entry].sort((a, b) => a.order - b.order) };
  return () => {
    registry.value = { ...registry.peek(), [slot]: (registry.peek()[slot] ?? []).filter((other) => other !== entry) };
  };
}

export function entriesOf(slot: SlotName): readonly SlotEntry[] {
  return registry.value[slot] ?? [];
}

/**
 * Takes the pointer from the camera while it is active, for drawing on the stage (a line, a choice). Coordinates are pixels of the full picture
 * and may be fractions; outside of the picture they lie outside of it, too.
 */
export interface PointerTool {
  id: string;
  cursor: string;
  onDown(x: number, y: number, event: PointerEvent): void;
  onMove(x: number, y: number, event: PointerEvent): void;
  onUp(x: number, y: number, event: PointerEvent): void;
}

export const pointerTool = signal<PointerTool | undefined>(undefined);
