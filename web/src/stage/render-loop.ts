// From the scene to pictures: whenever the scene, the stage's size or the engine changes, a picture is asked for, one at a time. During a gesture
// they are small enough for a smooth motion; at rest comes the full one. A scene that the engine refuses keeps the last picture and says why.
import { effect, untracked } from "@preact/signals";
import type { Engine, Picture, RenderRequest, SceneDoc } from "../engine/types";
import { engine } from "../state/engine";
import { isAborted, readable, retract, say, sayError } from "../state/messages";
import { fullRequest, fullSize, isDrawing, isPictureFinal, picture } from "../state/picture";
import { isTable } from "../state/path";
import { isDragging } from "../state/scene";
import { Pace } from "./pace";

const kAbout = "picture";
const kAboutNotes = "picture notes";
/** At rest a picture that takes longer than this is shown small first. */
const kQuickFirstMilliseconds = 140;

export const pace = new Pace();

let running = false;
let wanted: { request: RenderRequest; quick: boolean } | undefined;
/** the scene of the latest picture, quick or full */
let shown: SceneDoc | undefined;

function samplesOf(request: RenderRequest): number {
  const { samples } = request.scene.image ?? {};
  return request.samples ?? (typeof samples === "number" ? samples : 4);
}

/** Maps of depths cost the same at every size of the picture: small ones do while something moves. */
const kQuickShadowSize = 512;
const kQuickOcclusion = { directions: 16, size: 96 };

function quickScene(scene: SceneDoc): SceneDoc {
  const { shadow, occlusion, ground } = scene;
  const quick = { ...scene };
  if (shadow || ground) {
    const stated = isTable(shadow) ? shadow : {};
    const size = Math.min(kQuickShadowSize, typeof stated["size"] === "number" ? stated["size"] : kQuickShadowSize);
    quick["shadow"] = { ...stated, size };
  }
  if (occlusion) {
    quick["occlusion"] = { ...(isTable(occlusion) ? occlusion : {}), ...kQuickOcclusion };
  }
  return quick;
}

function quickRequest(request: RenderRequest): RenderRequest {
  const scale = pace.scaleFor(request.width * request.height);
  const width = Math.max(1, Math.round(request.width * scale));
  return { scene: quickScene(request.scene), width, height: Math.max(1, Math.round((width * request.height) / request.width)), samples: 1 };
}

let told = "";

/** The panel shows no key that does not apply, and keeps its value for when it does: that is no news to the reader. */
const kSleepingKey = /: changes nothing with /;

/** What the engine noticed while it drew is said once, and again when it is something else. */
function tell(notes: readonly string[]): void {
  const text = notes
    .filter((note) => !kSleepingKey.test(note))
    .map(readable)
    .join("\n");
  if (text === told) {
    return;
  }
  told = text;
  if (text === "") {
    retract(kAboutNotes);
  } else {
    say("note", text, kAboutNotes);
  }
}

function accept(drawn: Picture, request: RenderRequest, scene: SceneDoc, isFinal: boolean): void {
  const pixels = drawn.width * drawn.height;
  if (isFinal) {
    pace.learnFull(pixels, samplesOf(request), drawn.milliseconds);
  } else {
    pace.learnQuick(pixels, drawn.milliseconds);
  }
  shown = scene;
  if (isFinal) {
    tell(drawn.notes);
  }
  isPictureFinal.value = isFinal;
  picture.value = drawn;
}

/** Draws what is wanted until nothing more is. */
async function run(current: Engine): Promise<void> {
  running = true;
  isDrawing.value = true;
  while (wanted) {
    const { request, quick } = wanted;
    wanted = undefined;
    const isSlow = pace.expectedFull(request.width * request.height, samplesOf(request)) > kQuickFirstMilliseconds;
    const isNew = shown !== request.scene;
    try {
      if (quick || (isSlow && isNew)) {
        const small = quickRequest(request);
        accept(await current.render(small), small, request.scene, false);
        if (!quick && !wanted) {
          wanted = { request, quick: false };
        }
      } else {
        accept(await current.render(request), request, request.scene, true);
      }
      retract(kAbout);
    } catch (problem) {
      if (!isAborted(problem)) {
        sayError(problem, kAbout);
      }
    }
    // The browser shows the picture before the next one is asked for.
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
  running = false;
  isDrawing.value = false;
}

/** Starts the loop; the function that it returns ends it. */
export function startRenderLoop(): () => void {
  return effect(() => {
    const current = engine.value;
    const request = fullRequest.value;
    const quick = isDragging.value;
    if (!current || fullSize.value.width === 0) {
      return;
    }
    wanted = { request, quick };
    if (!running) {
      untracked(() => void run(current));
    }
  });
}
