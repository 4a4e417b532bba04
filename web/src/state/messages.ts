// What the page has to say: errors of files and of the engine, notes, successes. Each stays until it is dismissed or its cause is gone; screen
// readers hear it (layout/messages.tsx).
import { signal, type ReadonlySignal } from "@preact/signals";

export interface Message {
  id: number;
  kind: "error" | "warning" | "note" | "success";
  text: string;
  /** what it is about: a new message about the same replaces the old one, and retract() takes it away when all is well again */
  about: string;
}

const list = signal<readonly Message[]>([]);
export const messages: ReadonlySignal<readonly Message[]> = list;

let nextId = 1;

export function say(kind: Message["kind"], text: string, about = ""): number {
  const others = list.peek().filter((other) => (about === "" ? other.text !== text : other.about !== about));
  const id = nextId++;
  list.value = [...others, { id, kind, text, about }].slice(-8);
  return id;
}

export function dismiss(id: number): void {
  list.value = list.peek().filter((message) => message.id !== id);
}

/** The cause is gone. */
export function retract(about: string): void {
  if (list.peek().some((message) => message.about === about)) {
    list.value = list.peek().filter((message) => message.about !== about);
  }
}

/** Paths as the reader knows them: the engine keeps files in a folder of its own. */
export function readable(text: string): string {
  return text.replaceAll("/files/", "");
}

/** An error's own words. */
export function errorText(problem: unknown): string {
  return readable(problem instanceof Error ? problem.message : String(problem));
}

export function sayError(problem: unknown, about = ""): void {
  say("error", errorText(problem), about);
}

/** A newer request took the place of this one: no error at all. */
export function isAborted(problem: unknown): boolean {
  return problem instanceof DOMException && problem.name === "AbortError";
}
