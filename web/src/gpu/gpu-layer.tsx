// The graphics card's picture of what the stage shows, and how it differs from the engine's.
import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Picture } from "../engine/types";
import { comparison } from "../state/compare";
import { engine } from "../state/engine";
import { isAborted, retract, say, sayError } from "../state/messages";
import { newestOnly } from "../state/newest";
import { isPictureFinal, picture } from "../state/picture";
import { scene } from "../state/scene";
import { differenceOf, straight, type Difference } from "./difference";
import { GpuView } from "./gpu-view";
import { BytesCanvas } from "./picture-canvas";
import { Split } from "./split";
import { words } from "./words";

const kAbout = "gpu";

/** What was found out about the latest pair of pictures; undefined while there is none. */
export const gpuDifference = signal<(Difference & { width: number; height: number; of: Picture }) | undefined>(undefined);

/** Draws on the card what the stage shows. */
async function draw(view: GpuView): Promise<void> {
  const current = engine.peek();
  const drawn = picture.peek();
  const value = comparison.peek();
  if (!current || !drawn || value.kind !== "gpu") {
    return;
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
      gpuDifference.value = { ...difference, width: drawn.width, height: drawn.height, of: drawn };
    }
  } catch (problem) {
    if (!isAborted(problem)) {
      sayError(problem, kAbout);
    }
  }
}

/** After each picture of the stage; only the latest is of interest. */
function follow(view: GpuView): () => void {
  const again = newestOnly(() => draw(view));
  return effect(() => {
    void picture.value;
    void comparison.value;
    again();
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
            <BytesCanvas picture={found} testid="gpu-difference" />
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
