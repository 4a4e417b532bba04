// The profile's line: drawn on the picture by a drag, its ends moved by pointer or by arrow keys.
import { signal } from "@preact/signals";
import { IconButton } from "../layout/icon-button";
import { pictureRect } from "../stage/projection";
import { fullSize } from "../state/picture";
import { selectedPixel } from "../state/selection";
import { isSheetOpen, panelTab } from "../state/settings";
import { pointerTool } from "../state/slots";
import { profileCalls, profileCursor, profileLine, type Place } from "./state";
import { explainWords } from "./words";

const kLeastPixels = 4;
const isDrawing = signal(false);

const clamped = (value: number) => Math.min(1, Math.max(0, value));

/** A place of the full picture's pixels. */
function placeOf(x: number, y: number): Place {
  const { width, height } = fullSize.peek();
  return { x: clamped(x / width), y: clamped(y / height) };
}

/** The middle of a chosen pixel. */
export const placeOfPixel = ({ x, y }: { x: number; y: number }): Place => placeOf(x + 0.5, y + 0.5);

function lengthOf(): number {
  const line = profileLine.peek();
  const { width, height } = fullSize.peek();
  return line ? Math.hypot((line.to.x - line.from.x) * width, (line.to.y - line.from.y) * height) : 0;
}

/** Shows the profile; where no pixel is explained it is the one in the line's middle. */
export function showProfile(): void {
  const line = profileLine.peek();
  const { width, height } = fullSize.peek();
  if (line && !selectedPixel.peek()) {
    const middle = (a: number, b: number, size: number) => Math.min(size - 1, Math.floor(((a + b) / 2) * size));
    selectedPixel.value = { x: middle(line.from.x, line.to.x, width), y: middle(line.from.y, line.to.y, height) };
  }
  panelTab.value = "explain";
  isSheetOpen.value = true;
  profileCalls.value++;
}

export function removeLine(): void {
  profileLine.value = undefined;
  profileCursor.value = undefined;
}

export const kLineTool = {
  id: "line",
  cursor: "crosshair",
  onDown(x: number, y: number) {
    isDrawing.value = true;
    profileCursor.value = undefined;
    profileLine.value = { from: placeOf(x, y), to: placeOf(x, y) };
  },
  onMove(x: number, y: number) {
    const line = profileLine.peek();
    if (isDrawing.peek() && line) {
      profileLine.value = { ...line, to: placeOf(x, y) };
    }
  },
  onUp() {
    isDrawing.value = false;
    pointerTool.value = undefined;
    if (lengthOf() < kLeastPixels) {
      removeLine();
    } else {
      showProfile();
    }
  },
};

export function LineButton() {
  const t = explainWords.value;
  const isOn = pointerTool.value?.id === kLineTool.id;
  return (
    <IconButton
      icon="profile"
      label={t.drawLine}
      isPressed={isOn}
      testid="line-tool"
      onClick={() => (pointerTool.value = isOn ? undefined : kLineTool)}
    />
  );
}

const kSteps: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

function End({ end }: { end: "from" | "to" }) {
  const t = explainWords.value;
  const line = profileLine.value!;
  const { width, height } = pictureRect.value;
  const moveTo = (place: Place) => (profileLine.value = { ...profileLine.peek()!, [end]: place });
  const onKey = (event: KeyboardEvent) => {
    const step = kSteps[event.key];
    if (step) {
      const { width: columns, height: rows } = fullSize.peek();
      const size = event.shiftKey ? 10 : 1;
      const at = profileLine.peek()![end];
      moveTo({ x: clamped(at.x + (step[0] * size) / columns), y: clamped(at.y + (step[1] * size) / rows) });
      event.preventDefault();
      event.stopPropagation();
    }
  };
  const onMove = (event: PointerEvent) => {
    const target = event.currentTarget as SVGElement;
    if (target.hasPointerCapture(event.pointerId)) {
      const rect = target.ownerSVGElement!.getBoundingClientRect();
      moveTo({ x: clamped((event.clientX - rect.left) / rect.width), y: clamped((event.clientY - rect.top) / rect.height) });
    }
  };
  return (
    <circle
      data-handle
      data-testid={`line-${end}`}
      class="x-line-end"
      cx={line[end].x * width}
      cy={line[end].y * height}
      r="7"
      tabindex={0}
      role="button"
      aria-label={end === "from" ? t.lineStart : t.lineEnd}
      onKeyDown={onKey}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={onMove}
    />
  );
}

export function LineOverlay() {
  const line = profileLine.value;
  const { width, height } = pictureRect.value;
  if (!line) {
    return null;
  }
  const at = (share: number) => ({
    x: (line.from.x + (line.to.x - line.from.x) * share) * width,
    y: (line.from.y + (line.to.y - line.from.y) * share) * height,
  });
  const cursor = profileCursor.value === undefined ? undefined : at(profileCursor.value);
  return (
    <g class="x-profile-line" data-testid="profile-line">
      <path d={`M${at(0).x} ${at(0).y}L${at(1).x} ${at(1).y}`} />
      <End end="from" />
      <End end="to" />
      {cursor ? <circle class="x-line-cursor" cx={cursor.x} cy={cursor.y} r="4" /> : null}
    </g>
  );
}
