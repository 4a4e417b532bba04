// The graphics card's picture of what the stage shows, and how it differs from the engine's.
import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Picture } from "../engine/types";
import { comparison } from "../state/compare";
import { engine } from "../state/engine";
import { isAborted, retract, say, sayError } from "../state/messages";
import { isPictureFinal, picture } from "../state/picture";
import { scene } from "../state/scene";
import { differenceOf, straight, type Difference } from "./difference";
import { GpuView } from "./gpu-view";
import { BytesCanvas } from "./picture-canvas";
import { Split } from "./split";
import { words } from "./words";

const kAbout = "gpu";

/** What was found out about the latest pair of pictures; undefined while there is none. */
export const gpuDifference = signal<(Difference & { of: Picture }) | undefined>(undefined);
const differencePicture = signal<{ width: number; height: number; bytes: Uint8ClampedArray<ArrayBuffer> } | undefined>(undefined);

/** Draws on the card after each picture of the stage; only the latest is of interest. */
function follow(view: GpuView): () => void {
  let isBusy = false;
  let isStale = false;
  const draw = async () => {
    if (isBusy) {
      isStale = true;
      return;
    }
    isBusy = true;
    do {
      isStale = false;
      const current = engine.peek();
      const drawn = picture.peek();
      const { value } = comparison;
      if (!current || !drawn || value.kind !== "gpu") {
        break;
      }
      try {
        const request = { scene: scene.peek(), width: drawn.width, height: drawn.height, ...(isPictureFinal.peek() ? {} : { samples: 1 }) };
        const gpuScene = await current.gpuScene(request, view.canDrawLinear);
        await view.prepare(gpuScene, (key) => current.gpuGeometry(key));
        view.draw(gpuScene);
        const missing = gpuScene.missing.join(", ");
        if (missing === "") {
          retract(kAbout);
        } else {
          say("note", words.peek().missing(missing), kAbout);
        }
        if (picture.peek() === drawn) {
          const difference = differenceOf(drawn.bytes, straight(view.read()), value.gain);
          gpuDifference.value = { ...difference, of: drawn };
          differencePicture.value = { width: drawn.width, height: drawn.height, bytes: difference.bytes };
        }
      } catch (problem) {
        if (!isAborted(problem)) {
          sayError(problem, kAbout);
        }
      }
    } while (isStale);
    isBusy = false;
  };
  return effect(() => {
    void picture.value;
    void comparison.value;
    void draw();
  });
}

export function GpuLayer() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const view = GpuView.create(canvas.current!);
    if (!view) {
      say("error", words.peek().noWebGl, kAbout);
      comparison.value = { kind: "none" };
      return undefined;
    }
    const lost = (event: Event) => {
      event.preventDefault();
      say("error", words.peek().lost, kAbout);
      comparison.value = { kind: "none" };
    };
    canvas.current!.addEventListener("webglcontextlost", lost);
    const element = canvas.current!;
    const stop = follow(view);
    return () => {
      stop();
      element.removeEventListener("webglcontextlost", lost);
      view.dispose();
      retract(kAbout);
      gpuDifference.value = undefined;
      differencePicture.value = undefined;
    };
  }, []);
  const { value } = comparison;
  if (value.kind !== "gpu") {
    return null;
  }
  const card = <canvas ref={canvas} class="picture" data-testid="gpu-picture" aria-hidden="true" />;
  const found = gpuDifference.value;
  return (
    <>
      {value.show === "wipe" ? (
        <Split leftLabel={words.value.engine} rightLabel={words.value.card}>
          {card}
        </Split>
      ) : (
        <div class="split" style={value.show === "difference" ? { visibility: "hidden" } : {}}>
          <div class="split-pane">{card}</div>
        </div>
      )}
      {value.show === "difference" && (
        <div class="split">
          <div class="split-pane">
            <BytesCanvas picture={differencePicture.value} testid="gpu-difference" />
          </div>
        </div>
      )}
      {found && (
        <output
          class="split-report"
          data-testid="gpu-report"
          data-current={found.of === picture.value && isPictureFinal.value}
          data-share={found.shareOver}
          data-most={found.most}
        >
          {words.value.differ(`${(found.shareOver * 100).toFixed(3)} %`, Math.round(found.most))}
        </output>
      )}
    </>
  );
}
