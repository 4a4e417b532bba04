// The words of the plots in both languages.
import { computed, type ReadonlySignal } from "@preact/signals";
import { language } from "../state/settings";

const en = {
  falloff: (reach: string, at: string) => `The light's attenuation over the distance, from 0 to ${reach} units. ${at}`,
  falloffAt: (distance: string, value: string) => `At ${distance} it is ${value}.`,
  cone: (cutoff: string, at: string) => `The spot's factor over the angle from its axis; the cone ends at ${cutoff} degrees. ${at}`,
  lobe: (formula: string, n: string, value: string, peak: string) =>
    `Polar plot of the highlight ${formula}, n = ${n}: ${value} towards the eye, at most ${peak} in the plane of N and L.`,
  distance: "distance",
  angle: "angle",
};

const it: typeof en = {
  falloff: (reach, at) => `L’attenuazione della luce con la distanza, da 0 a ${reach} unità. ${at}`,
  falloffAt: (distance, value) => `A ${distance} vale ${value}.`,
  cone: (cutoff, at) => `Il fattore del faretto secondo l’angolo dal suo asse; il cono finisce a ${cutoff} gradi. ${at}`,
  lobe: (formula, n, value, peak) =>
    `Grafico polare del riflesso ${formula}, n = ${n}: ${value} verso l’occhio, al massimo ${peak} nel piano di N e L.`,
  distance: "distanza",
  angle: "angolo",
};

export const plotWords: ReadonlySignal<typeof en> = computed(() => (language.value === "it" ? it : en));
