// What belongs to the reader and not to the scene: language, theme, panel. Kept in localStorage where that is allowed.
import { computed, effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";

export type Language = "en" | "it";
/** `system` follows the system's setting */
export type Theme = "system" | "light" | "dark";
export type PanelTab = "shading" | "material" | "lights" | "camera" | "scene" | "explain";

const kPrefix = "lustro.";

function stored(key: string): string | null {
  try {
    return localStorage.getItem(kPrefix + key);
  } catch {
    return null;
  }
}

function kept<T extends string>(key: string, words: readonly T[], start: T): Signal<T> {
  const before = stored(key);
  const value = signal<T>(words.find((word) => word === before) ?? start);
  let isFirst = true;
  effect(() => {
    const word = value.value;
    if (isFirst) {
      isFirst = false;
      return;
    }
    try {
      localStorage.setItem(kPrefix + key, word);
    } catch {
      // a browser that keeps nothing: the setting lives as long as the page
    }
  });
  return value;
}

const ofBrowser: Language = typeof navigator !== "undefined" && navigator.language.toLowerCase().startsWith("it") ? "it" : "en";

export const language = kept<Language>("language", ["en", "it"], ofBrowser);
export const theme = kept<Theme>("theme", ["system", "light", "dark"], "system");
export const panelTab = kept<PanelTab>("tab", ["shading", "material", "lights", "camera", "scene", "explain"], "shading");

/** Help texts stand below their controls, not only in tooltips. */
export const showsHelp = kept<"on" | "off">("help", ["on", "off"], "off");

/** What to do with the picture is said until it was read. */
export const hint = kept<"new" | "read">("hint", ["new", "read"], "new");

/** Small screens: the sheet with the panels is open. */
export const isSheetOpen = signal(false);

const prefersDark = signal(typeof matchMedia === "function" && matchMedia("(prefers-color-scheme: dark)").matches);
if (typeof matchMedia === "function") {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) => (prefersDark.value = event.matches));
}

export const isDark: ReadonlySignal<boolean> = computed(() => theme.value === "dark" || (theme.value === "system" && prefersDark.value));
