// The stage's own tools and marks: framing, the chosen pixel.
import { words } from "../i18n";
import { frameAll } from "../stage/camera";
import { pixelToStage } from "../stage/projection";
import { selectedPixel } from "../state/selection";
import { register } from "../state/slots";
import { IconButton } from "./icon-button";

function FrameButton() {
  const text = words.value.stage.frame;
  return <IconButton icon="frame" label={text} title={`${text} (F)`} testid="frame" onClick={frameAll} />;
}

function PixelMark() {
  const pixel = selectedPixel.value;
  if (!pixel) {
    return null;
  }
  const { x, y } = pixelToStage.value(pixel.x, pixel.y);
  return (
    <g class="pixel-mark" transform={`translate(${x} ${y})`} data-testid="pixel-mark">
      <circle r="9" />
      <path d="M-16 0h-7M16 0h7M0-16v-7M0 16v7" />
    </g>
  );
}

register("stageTool", { id: "frame", order: 10, component: FrameButton });
register("overlay", { id: "pixel", order: 100, component: PixelMark });
