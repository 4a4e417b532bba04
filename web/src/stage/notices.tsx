// What the stage says about itself: that the engine starts or did not, that a picture is being drawn, and, to a first-time visitor, what can be done.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { words } from "../i18n";
import { IconButton } from "../layout/icon-button";
import { engineStatus } from "../state/engine";
import { isDrawing, picture } from "../state/picture";
import { selectedPixel } from "../state/selection";
import { hint } from "../state/settings";

/** A finger neither clicks nor drops files. */
const isTouch = matchMedia("(hover: none)").matches;

/** The hint goes for good once a pixel was read, or when it is told to. */
function Hint() {
  const t = words.value;
  useEffect(
    () =>
      selectedPixel.subscribe((pixel) => {
        if (pixel) {
          hint.value = "read";
        }
      }),
    [],
  );
  if (hint.value === "read" || !picture.value) {
    return null;
  }
  return (
    <p class="hint" data-testid="hint">
      <span>{isTouch ? t.stage.touchHint : t.stage.hint}</span>
      <IconButton icon="close" label={t.messages.dismiss} isSmall onClick={() => (hint.value = "read")} />
    </p>
  );
}

const isLong = signal(false);

/** A line along the stage's top edge, when drawing takes long enough to be waited for. */
function Progress() {
  const busy = isDrawing.value;
  useEffect(() => {
    const timer = setTimeout(() => (isLong.value = busy), busy ? 250 : 0);
    return () => clearTimeout(timer);
  }, [busy]);
  return busy && isLong.value ? <div class="drawing" data-testid="drawing" /> : null;
}

export function Notices() {
  const t = words.value.stage;
  return (
    <>
      {engineStatus.value === "starting" ? (
        <p class="stage-note" role="status" data-testid="engine-starting">
          {t.starting}
        </p>
      ) : null}
      {engineStatus.value === "failed" ? (
        <p class="stage-note" role="alert" data-testid="engine-failed">
          {t.failed}
        </p>
      ) : null}
      <Progress />
      <Hint />
    </>
  );
}
