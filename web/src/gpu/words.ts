// What the comparisons say, in both languages.
import { computed, type ReadonlySignal } from "@preact/signals";
import { language } from "../state/settings";

const en = {
  compare: "Compare",
  title: "Two pictures beside each other",
  off: "One picture",
  gpu: "Engine and graphics card",
  gpuHelp: "The same equation in GLSL, drawn by WebGL2. Both should agree but for edges.",
  settings: "Two settings",
  show: "Show",
  showGpu: "Graphics card",
  showWipe: "Wipe",
  showDifference: "Difference",
  gain: "Difference times",
  layout: "Layout",
  sideBySide: "Side by side",
  left: "Left",
  right: "Right",
  custom: "Own choice",
  lighting: "Lighting model",
  interpolation: "Interpolation",
  asItIs: "as it is",
  wipe: "Where the left picture ends",
  engine: "engine",
  card: "graphics card",
  noWebGl: "This browser has no WebGL2: the graphics card's picture cannot be shown. The engine's picture needs none.",
  missing: (what: string) => `The graphics card's picture leaves out: ${what}.`,
  differ: (share: string, most: number) => `${share} of the pixels differ by more than 2/255; the largest difference is ${most}/255.`,
  lost: "The browser took the graphics card away; choose the comparison again.",
};

export type Words = typeof en;

const it: Words = {
  compare: "Confronta",
  title: "Due immagini a confronto",
  off: "Una sola immagine",
  gpu: "Motore e scheda grafica",
  gpuHelp: "La stessa equazione in GLSL, disegnata da WebGL2. Devono coincidere, bordi a parte.",
  settings: "Due impostazioni",
  show: "Mostra",
  showGpu: "Scheda grafica",
  showWipe: "Tendina",
  showDifference: "Differenza",
  gain: "Differenza per",
  layout: "Disposizione",
  sideBySide: "Affiancate",
  left: "Sinistra",
  right: "Destra",
  custom: "Scelta libera",
  lighting: "Modello di illuminazione",
  interpolation: "Interpolazione",
  asItIs: "com’è",
  wipe: "Dove finisce l’immagine di sinistra",
  engine: "motore",
  card: "scheda grafica",
  noWebGl: "Questo browser non ha WebGL2: l’immagine della scheda grafica non si può mostrare. Quella del motore non ne ha bisogno.",
  missing: (what) => `L’immagine della scheda grafica non comprende: ${what}.`,
  differ: (share, most) => `${share} dei pixel differisce di più di 2/255; la differenza massima è ${most}/255.`,
  lost: "Il browser ha tolto la scheda grafica; scegliere di nuovo il confronto.",
};

export const words: ReadonlySignal<Words> = computed(() => (language.value === "it" ? it : en));
