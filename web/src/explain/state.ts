// What Explain remembers: the explanation that is shown, what of it is drawn in the picture, the line of the profile.
import { computed, signal, type ReadonlySignal } from "@preact/signals";
import type { Explanation, FragmentExplanation, ShadingExplanation } from "../engine/types";
import { explanation } from "../state/selection";
import { heaviestShading, strongestLight, type Channel } from "./equation";

/** The newest explanation: it stays while a newer one is asked for, so that the panel does not flicker. Written by ask.ts. */
export const shownExplanation = signal<Explanation | undefined>(undefined);

/** The shown explanation is not of the chosen pixel as the picture shows it now. */
export const isStale: ReadonlySignal<boolean> = computed(() => explanation.value === undefined);

/** Why the engine could not explain the chosen pixel, in its words. Written by ask.ts. */
export const explainFailure = signal<string | undefined>(undefined);

/** Of the pixel under the pointer. */
export const hoveredExplanation = signal<Explanation | undefined>(undefined);

export const chosenChannel = signal<Channel | undefined>(undefined);

/** The channel in the formulas: the brightest, unless one was chosen. */
export const channel: ReadonlySignal<Channel> = computed(() => {
  const rgb = shownExplanation.value?.color.slice(0, 3) ?? [1, 0, 0];
  return chosenChannel.value ?? (rgb.indexOf(Math.max(...rgb)) as Channel);
});

export type DrawnName = "N" | "L" | "V" | "R" | "H" | "lights" | "triangle";
export const kDrawn: readonly DrawnName[] = ["N", "L", "V", "R", "H", "lights", "triangle"];
export const drawn = signal<Readonly<Record<DrawnName, boolean>>>({
  N: true,
  L: true,
  V: true,
  R: true,
  H: true,
  lights: true,
  triangle: true,
});

/** The light whose vectors and lobe are shown: by its index among the scene's; undefined: the strongest. */
export const chosenLight = signal<number | undefined>(undefined);

/** The evaluation whose vectors are shown. */
export interface Subject {
  fragment: FragmentExplanation;
  shading: ShadingExplanation;
  /** index into shading.lights; -1 where there is none */
  light: number;
}

export const subject: ReadonlySignal<Subject | undefined> = computed(() => {
  const e = shownExplanation.value;
  const fragment =
    e && e.fragments.reduce<FragmentExplanation | undefined>((best, f) => (best && best.weight >= f.weight ? best : f), undefined);
  const shading = fragment?.shadings[heaviestShading(fragment)];
  if (!fragment || !shading) {
    return undefined;
  }
  const chosen = shading.lights.findIndex((light) => light.light === chosenLight.value);
  return { fragment, shading, light: chosen >= 0 ? chosen : shading.lights.length > 0 ? strongestLight(shading) : -1 };
});

/** A place of the picture, 0..1 from its upper left corner: the line stays where it is when the picture's size changes. */
export interface Place {
  x: number;
  y: number;
}
export const profileLine = signal<{ from: Place; to: Place } | undefined>(undefined);

/** The profile shows flat, Gouraud and Phong shading, not the picture's own channels. */
export const isProfileComparing = signal(false);

/** The profile's values are as they are stored (sRGB), not linear. */
export const isProfileEncoded = signal(false);

/** Where on the line the plot's cursor stands, 0..1. */
export const profileCursor = signal<number | undefined>(undefined);

/** The profile wants to be seen: the panel scrolls to it. */
export const profileCalls = signal(0);
