// Two settings of one scene, seen by the same camera: both pictures by the engine. They follow every picture of the stage, in its size.
import { effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Picture } from "../engine/types";
import { comparedScenes, comparison } from "../state/compare";
import { engine } from "../state/engine";
import { isAborted, retract, sayError } from "../state/messages";
import { newestOnly } from "../state/newest";
import { isPictureFinal, picture } from "../state/picture";
import { scene } from "../state/scene";
import { BytesCanvas } from "./picture-canvas";
import { Split } from "./split";
import { sideLabel } from "./settings";

const kAbout = "compare";
/** `of`: the stage's picture that they lie over, `how`: what they differ in. */
const sides = signal<{ left: Picture; right: Picture; of: Picture; how: ReturnType<typeof comparedScenes.peek> } | undefined>(undefined);

/** Draws both sides as the stage's picture is drawn. */
async function draw(): Promise<void> {
  const current = engine.peek();
  const how = comparedScenes.peek();
  const of = picture.peek();
  if (!current || !how || !of) {
    return;
  }
  const request = { width: of.width, height: of.height, ...(isPictureFinal.peek() ? {} : { samples: 1 }) };
  try {
    const left = await current.render({ ...request, scene: how.left }, true);
    const right = await current.render({ ...request, scene: how.right }, true);
    sides.value = { left, right, of, how };
    retract(kAbout);
  } catch (problem) {
    if (!isAborted(problem)) {
      sayError(problem, kAbout);
    }
  }
}

/** After each picture of the stage; only the latest is of interest. */
function follow(): () => void {
  const again = newestOnly(draw);
  return effect(() => {
    void picture.value;
    void comparedScenes.value;
    again();
  });
}

export function SettingsLayer() {
  useEffect(follow, []);
  const { value } = comparison;
  if (value.kind !== "settings") {
    return null;
  }
  const isCurrent = sides.value?.of === picture.value && sides.value?.how === comparedScenes.value && isPictureFinal.value;
  const left = <BytesCanvas picture={sides.value?.left} testid="compare-left" />;
  return (
    <>
      <div class="split-base" data-testid="compare-base" data-current={isCurrent}>
        {left}
      </div>
      <Split
        leftLabel={sideLabel(scene.value, value.left, value.right)}
        rightLabel={sideLabel(scene.value, value.right, value.left)}
        left={<BytesCanvas picture={sides.value?.left} testid="compare-left-pane" />}
      >
        <BytesCanvas picture={sides.value?.right} testid="compare-right" />
      </Split>
    </>
  );
}
