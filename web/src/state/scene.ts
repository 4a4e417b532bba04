// THE scene: one signal that holds a scene file's content. Everything on the page reads it from here and changes it by update(); nothing is kept
// twice. Steps can be undone; changes of one gesture (a drag, typing, a held key) are one step.
import { batch, computed, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import type { SceneDoc } from "../engine/types";
import { pathText, valueAt, withValue, type Path } from "./path";

/** All that a link restores and that undo goes back over. */
export interface LabDoc {
  scene: SceneDoc;
  /** lights that move with the camera, by their index: the scene file itself only knows where they are */
  attached: readonly number[];
}

interface Step {
  doc: LabDoc;
  /** of the change that led away from `doc` */
  key: string;
}

/** Changes of the same place that follow each other faster than this are one step. */
const kCoalesceMilliseconds = 800;
const kMostSteps = 300;
/** A wheel or a key that rests for so long has ended its gesture. */
const kRestMilliseconds = 180;

const current = signal<LabDoc>({ scene: { objects: [{ mesh: "primitive:teapot" }] }, attached: [] });
const past = signal<readonly Step[]>([]);
const future = signal<readonly Step[]>([]);
const drags = signal(0);

/** Gestures that are one step. */
let slowDrags = 0;
let lastKey = "";
let lastTime = -Infinity;

/** What is shown. Changed by update(), edit(), resetScene(), undo() and redo() alone. */
export const scene: ReadonlySignal<SceneDoc> = computed(() => current.value.scene);

/** Lights that are fixed to the camera. */
export const attachedLights: ReadonlySignal<readonly number[]> = computed(() => current.value.attached);

/** The scene with what the page adds to it. */
export const labDoc: ReadonlySignal<LabDoc> = current;

/** A gesture is going on: pictures may be small, and its changes are one step. */
export const isDragging: ReadonlySignal<boolean> = computed(() => drags.value > 0);

export const canUndo: ReadonlySignal<boolean> = computed(() => past.value.length > 0);
export const canRedo: ReadonlySignal<boolean> = computed(() => future.value.length > 0);

/** A signal of one place of the scene; it changes only when that place does. */
export function at<T = unknown>(path: Path): ReadonlySignal<T | undefined> {
  return computed(() => valueAt(scene.value, path) as T | undefined);
}

/**
 * Changes the scene by a function that returns the new one (the same object: nothing changes).
 * key   equal keys in one gesture, or soon after each other, are one step of undo; empty: always a step of its own
 */
export function edit(change: (scene: SceneDoc) => SceneDoc, key = ""): void {
  editLab((doc) => {
    const after = change(doc.scene);
    return after === doc.scene ? doc : { ...doc, scene: after };
  }, key);
}

/** The same for the scene and what the page adds to it. */
export function editLab(change: (doc: LabDoc) => LabDoc, key = ""): void {
  const before = current.peek();
  const after = change(before);
  if (after === before) {
    return;
  }
  const now = performance.now();
  const isSameGesture =
    key !== "" && key === lastKey && past.peek().length > 0 && (slowDrags > 0 || now - lastTime < kCoalesceMilliseconds);
  batch(() => {
    if (!isSameGesture) {
      past.value = [...past.peek(), { doc: before, key }].slice(-kMostSteps);
    }
    future.value = [];
    current.value = after;
  });
  lastKey = key;
  lastTime = now;
}

/** Completes the step before it: for what is known only once a picture is there. */
export function amend(change: (doc: LabDoc) => LabDoc): void {
  current.value = change(current.peek());
}

/** States a value of the scene; undefined takes the key away, so that its default holds. */
export function update(path: Path, value: unknown): void {
  edit((before) => (Object.is(valueAt(before, path), value) ? before : withValue(before, path, value)), pathText(path));
}

/** Several places in one step. */
export function updateAll(changes: readonly (readonly [Path, unknown])[], key = changes.map(([path]) => pathText(path)).join(",")): void {
  edit((before) => changes.reduce((doc, [path, value]) => withValue(doc, path, value), before), key);
}

/** Another scene altogether; `keep` leaves what came before it to undo. */
export function resetScene(doc: SceneDoc, { keep = false, attached = [] as readonly number[] } = {}): void {
  lastKey = "";
  if (keep) {
    editLab(() => ({ scene: doc, attached }));
    return;
  }
  batch(() => {
    past.value = [];
    future.value = [];
    current.value = { scene: doc, attached };
  });
}

function step(from: Signal<readonly Step[]>, to: Signal<readonly Step[]>): void {
  const last = from.peek().at(-1);
  if (last) {
    batch(() => {
      from.value = from.peek().slice(0, -1);
      to.value = [...to.peek(), { doc: current.peek(), key: last.key }];
      current.value = last.doc;
    });
    lastKey = "";
  }
}

/** The scene and its steps as they are now; the function that it returns brings them back. */
export function rememberScene(): () => void {
  const [doc, before, after] = [current.peek(), past.peek(), future.peek()];
  return () =>
    batch(() => {
      lastKey = "";
      past.value = before;
      future.value = after;
      current.value = doc;
    });
}

export function undo(): void {
  step(past, future);
}

export function redo(): void {
  step(future, past);
}

/**
 * Begins a gesture; the function that it returns ends it (once, however often it is called).
 * isOneStep  its changes of the same place are one step of undo, however slow it is; else only those that follow each other soon
 */
export function beginDrag(isOneStep = true): () => void {
  let isOver = false;
  drags.value++;
  if (isOneStep) {
    lastKey = "";
    slowDrags++;
  }
  return () => {
    if (isOver) {
      return;
    }
    isOver = true;
    drags.value--;
    if (isOneStep) {
      lastKey = "";
      slowDrags--;
    }
  };
}

/** A gesture without an end of its own (the wheel, keys, typing): it is over when nothing came for a moment. Call it at each change. */
export function pausingDrag(): () => void {
  let end: (() => void) | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  return () => {
    end ??= beginDrag(false);
    clearTimeout(timer);
    timer = setTimeout(() => {
      end?.();
      end = undefined;
    }, kRestMilliseconds);
  };
}
