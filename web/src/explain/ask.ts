// Asks the engine about the chosen pixel, and the one under the pointer: one question at a time, the newest first, and only when the picture is
// at rest, so that pictures of a drag never wait for it.
import { effect, untracked } from "@preact/signals";
import type { Explanation } from "../engine/types";
import { engine } from "../state/engine";
import { errorText, isAborted } from "../state/messages";
import { fullRequest, fullSize, isPictureFinal, picture } from "../state/picture";
import { isDragging } from "../state/scene";
import { explanation, hoveredPixel, selectedPixel, type PixelPlace } from "../state/selection";
import { isSheetOpen, panelTab } from "../state/settings";
import { pointerTool } from "../state/slots";
import { explainFailure, hoveredExplanation, shownExplanation } from "./state";

const kHoverMilliseconds = 90;

interface Question {
  pixel: PixelPlace;
  answer: (answered: Explanation | undefined) => void;
}

let isAsking = false;
let chosen: Question | undefined;
let hovered: Question | undefined;

async function ask(): Promise<void> {
  isAsking = true;
  for (;;) {
    const question = chosen ?? hovered;
    const current = engine.peek();
    if (!question || !current) {
      break;
    }
    const isChosen = question === chosen;
    chosen = isChosen ? undefined : chosen;
    hovered = isChosen ? hovered : undefined;
    try {
      const answered = await current.explain(fullRequest.peek(), question.pixel.x, question.pixel.y);
      question.answer(answered);
    } catch (problem) {
      question.answer(undefined);
      if (isChosen && !isAborted(problem)) {
        explainFailure.value = errorText(problem);
      }
    }
  }
  isAsking = false;
}

function put(): void {
  if (!isAsking) {
    untracked(() => void ask());
  }
}

function isInside(pixel: PixelPlace): boolean {
  const { width, height } = fullSize.peek();
  return pixel.x < width && pixel.y < height;
}

interface Size {
  width: number;
  height: number;
}

/** A pixel of one size in a picture of another size: the view's height stays, what is seen beside it changes. Undefined: out of sight. */
export function movedPixel(pixel: PixelPlace, from: Size, to: Size): PixelPlace | undefined {
  const scale = to.height / from.height;
  const x = Math.floor((pixel.x + 0.5 - from.width / 2) * scale + to.width / 2);
  const y = Math.floor((pixel.y + 0.5) * scale);
  return x >= 0 && y >= 0 && x < to.width && y < to.height ? { x, y } : undefined;
}

/** Whether the picture stands still and is the scene's. */
const isAtRest = () => isPictureFinal.value && picture.value !== undefined && !isDragging.value && engine.value !== undefined;

export function startAsking(): () => void {
  const stopChosen = effect(() => {
    const pixel = selectedPixel.value;
    const ready = isAtRest();
    explanation.value = undefined;
    chosen = undefined;
    if (!pixel) {
      shownExplanation.value = undefined;
      explainFailure.value = undefined;
      return;
    }
    if (ready && isInside(pixel)) {
      chosen = {
        pixel,
        answer: (answered) => {
          if (answered && selectedPixel.peek() === pixel && !chosen) {
            explainFailure.value = undefined;
            shownExplanation.value = answered;
            explanation.value = answered;
          }
        },
      };
      put();
    }
  });

  // The surface's point that was chosen stays the chosen one when the picture gets another size.
  let size = fullSize.peek();
  const stopSize = effect(() => {
    const next = fullSize.value;
    const pixel = selectedPixel.peek();
    if (pixel && size.height > 0 && next.height > 0) {
      selectedPixel.value = movedPixel(pixel, size, next);
    }
    size = next;
  });

  let timer: ReturnType<typeof setTimeout> | undefined;
  const stopHovered = effect(() => {
    const pixel = hoveredPixel.value;
    const ready = isAtRest() && panelTab.value === "explain" && !pointerTool.value;
    clearTimeout(timer);
    hovered = undefined;
    hoveredExplanation.value = undefined;
    if (pixel && ready && isInside(pixel)) {
      timer = setTimeout(() => {
        hovered = {
          pixel,
          answer: (answered) => {
            if (hoveredPixel.peek() === pixel) {
              hoveredExplanation.value = answered;
            }
          },
        };
        put();
      }, kHoverMilliseconds);
    }
  });

  // Who chooses a pixel wants to read it.
  let before: PixelPlace | undefined;
  const stopTab = effect(() => {
    const pixel = selectedPixel.value;
    if (pixel && !before) {
      panelTab.value = "explain";
      isSheetOpen.value = true;
    }
    before = pixel;
  });

  return () => {
    stopChosen();
    stopSize();
    stopHovered();
    stopTab();
    clearTimeout(timer);
    chosen = undefined;
    hovered = undefined;
  };
}
