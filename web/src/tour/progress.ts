// Which lessons are done, and where the reader stopped: kept in localStorage where that is allowed.
import { signal, type ReadonlySignal } from "@preact/signals";

export interface Progress {
  /** ids of lessons whose last question was answered */
  done: readonly string[];
  /** where to go on */
  at?: { lesson: string; step: number } | undefined;
}

const kKey = "lustro.tour";

function stored(): Progress {
  try {
    const { done, at } = JSON.parse(localStorage.getItem(kKey) ?? "{}") as Partial<Progress>;
    return {
      done: Array.isArray(done) ? done.filter((id) => typeof id === "string") : [],
      at: typeof at?.lesson === "string" && Number.isInteger(at.step) ? at : undefined,
    };
  } catch {
    return { done: [] };
  }
}

const current = signal<Progress>(stored());
export const progress: ReadonlySignal<Progress> = current;

function keep(next: Progress): void {
  current.value = next;
  try {
    localStorage.setItem(kKey, JSON.stringify(next));
  } catch {
    // a browser that keeps nothing: progress lives as long as the page
  }
}

export function markPlace(lesson: string, step: number): void {
  keep({ ...current.peek(), at: { lesson, step } });
}

export function markDone(lesson: string): void {
  const { done } = current.peek();
  keep({ done: done.includes(lesson) ? done : [...done, lesson], at: undefined });
}
