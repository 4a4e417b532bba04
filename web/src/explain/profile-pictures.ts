// The pictures that the profile reads: the shown one with its floats, or the same view with flat, Gouraud and Phong interpolation.
import { effect, signal, untracked } from "@preact/signals";
import type { Picture, RenderRequest } from "../engine/types";
import { engine } from "../state/engine";
import { isAborted, retract, sayError } from "../state/messages";
import { withValue } from "../state/path";
import { fullRequest, isPictureFinal } from "../state/picture";
import { isDragging } from "../state/scene";
import { isProfileComparing, profileLine } from "./state";

export type Shown = "current" | "flat" | "gouraud" | "phong";
export const kInterpolations = ["flat", "gouraud", "phong"] as const;

export const isMeasuring = signal(false);
/** of the request, by what they show; those that are not asked for yet are missing */
export const profilePictures = signal<Partial<Record<Shown, Picture>>>({});

let request: RenderRequest | undefined;
let isRunning = false;

function wanted(): Shown[] {
  return isProfileComparing.peek() ? [...kInterpolations] : ["current"];
}

async function draw(): Promise<void> {
  isRunning = true;
  isMeasuring.value = true;
  for (;;) {
    const current = engine.peek();
    const asked = fullRequest.peek();
    if (request !== asked) {
      request = asked;
      profilePictures.value = {};
    }
    const next = wanted().find((shown) => !profilePictures.peek()[shown]);
    if (!current || !next || !profileLine.peek() || !isPictureFinal.peek() || isDragging.peek()) {
      break;
    }
    try {
      const scene = next === "current" ? asked.scene : withValue(asked.scene, "shading.interpolation", next);
      const picture = await current.render({ ...asked, scene, floats: true }, true);
      if (fullRequest.peek() === asked) {
        profilePictures.value = { ...profilePictures.peek(), [next]: picture };
      }
      retract("profile");
    } catch (problem) {
      if (!isAborted(problem)) {
        sayError(problem, "profile");
      }
      break;
    }
  }
  isRunning = false;
  isMeasuring.value = false;
}

/** Keeps the pictures up to date while the profile is looked at; the function that it returns ends that and lets them go. */
export function startMeasuring(): () => void {
  const stop = effect(() => {
    const isReady =
      engine.value &&
      profileLine.value &&
      isPictureFinal.value &&
      !isDragging.value &&
      fullRequest.value &&
      isProfileComparing.value !== undefined;
    if (isReady && !isRunning) {
      untracked(() => void draw());
    }
  });
  return () => {
    stop();
    request = undefined;
    profilePictures.value = {};
  };
}
