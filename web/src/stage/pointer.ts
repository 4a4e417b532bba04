// The camera by pointer, wheel and keys, and the choice of a pixel by a click. One finger or the left button turns, two fingers or another button
// (or shift) move and pinch, the wheel zooms at the pointer, a double click makes a surface's point the target.
import { engine } from "../state/engine";
import { isAborted, sayError } from "../state/messages";
import { fullRequest, fullSize } from "../state/picture";
import { beginDrag, pausingDrag } from "../state/scene";
import { hoveredPixel, selectedPixel, type PixelPlace } from "../state/selection";
import { pointerTool } from "../state/slots";
import { currentPose, orbited, panned, pointUnder, unitsPerPixel, writePose, zoomed, type Pose } from "./camera";
import { handleKey } from "./keys";
import { pictureRect } from "./projection";
import { subtract } from "./vector";

const kClickPixels = 5;

interface Finger {
  x: number;
  y: number;
}

async function targetAt(pixel: PixelPlace): Promise<void> {
  const current = engine.peek();
  const pose = currentPose();
  if (!current || !pose) {
    return;
  }
  try {
    const point = (await current.explain(fullRequest.peek(), pixel.x, pixel.y)).fragments[0]?.position;
    if (point) {
      const shift = subtract(point, pose.target);
      writePose({ ...pose, target: point, eye: [pose.eye[0] + shift[0], pose.eye[1] + shift[1], pose.eye[2] + shift[2]] }, "");
    }
  } catch (problem) {
    if (!isAborted(problem)) {
      sayError(problem, "target");
    }
  }
}

/** Listens on the stage's element; the function that it returns stops that. */
export function attachPointer(element: HTMLElement): () => void {
  const fingers = new Map<number, Finger>();
  let endDrag: (() => void) | undefined;
  let pose: Pose | undefined;
  let moved = 0;
  let isPanning = false;
  const pause = pausingDrag();

  const place = (event: MouseEvent): Finger => {
    const rect = element.getBoundingClientRect();
    return { x: event.clientX - rect.left, y: event.clientY - rect.top };
  };
  const pixelAt = ({ x, y }: Finger): PixelPlace => {
    const full = fullSize.peek();
    const rect = pictureRect.peek();
    return { x: (x * full.width) / rect.width, y: (y * full.height) / rect.height };
  };
  const wholePixel = (at: Finger): PixelPlace | undefined => {
    const { x, y } = pixelAt(at);
    const full = fullSize.peek();
    return x >= 0 && y >= 0 && x < full.width && y < full.height ? { x: Math.floor(x), y: Math.floor(y) } : undefined;
  };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return a && b ? { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, size: Math.hypot(a.x - b.x, a.y - b.y) } : undefined;
  };

  const onDown = (event: PointerEvent) => {
    if ((event.target as Element).closest("[data-handle]")) {
      return;
    }
    element.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    const tool = pointerTool.peek();
    if (tool && event.button === 0 && fingers.size === 1) {
      const { x, y } = pixelAt(place(event));
      tool.onDown(x, y, event);
      return;
    }
    if (fingers.size === 1) {
      moved = 0;
      isPanning = event.button !== 0 || event.shiftKey || event.ctrlKey || event.metaKey;
    } else {
      moved = Infinity;
    }
    pose = currentPose();
  };

  const onMove = (event: PointerEvent) => {
    const at = place(event);
    const before = fingers.get(event.pointerId);
    const tool = pointerTool.peek();
    if (!before) {
      hoveredPixel.value = wholePixel(at);
    }
    if (tool) {
      const { x, y } = pixelAt(at);
      tool.onMove(x, y, event);
      return;
    }
    if (!before || !pose) {
      return;
    }
    const pinched = spread();
    fingers.set(event.pointerId, at);
    const dx = at.x - before.x;
    const dy = at.y - before.y;
    moved += Math.hypot(dx, dy);
    if (moved < kClickPixels) {
      return;
    }
    endDrag ??= beginDrag();
    const perPixel = unitsPerPixel(pose);
    const now = spread();
    if (pinched && now) {
      pose = panned(pose, -(now.x - pinched.x) * perPixel, (now.y - pinched.y) * perPixel);
      if (pinched.size > 0 && now.size > 0) {
        pose = zoomed(pose, pinched.size / now.size);
      }
    } else if (isPanning) {
      pose = panned(pose, -dx * perPixel, dy * perPixel);
    } else {
      const perRadian = Math.max(240, Math.min(pictureRect.peek().width, pictureRect.peek().height)) / Math.PI;
      pose = orbited(pose, -dx / perRadian, dy / perRadian);
    }
    writePose(pose);
  };

  const onUp = (event: PointerEvent) => {
    const at = place(event);
    if (!fingers.delete(event.pointerId)) {
      return;
    }
    const tool = pointerTool.peek();
    if (tool) {
      const { x, y } = pixelAt(at);
      tool.onUp(x, y, event);
      return;
    }
    if (fingers.size === 0) {
      if (moved < kClickPixels && event.type === "pointerup" && event.button === 0) {
        selectedPixel.value = wholePixel(at);
      }
      endDrag?.();
      endDrag = undefined;
      pose = undefined;
    } else {
      isPanning = false;
    }
  };

  const onWheel = (event: WheelEvent) => {
    const start = currentPose();
    if (!start) {
      return;
    }
    event.preventDefault();
    pause();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY / 100 : event.deltaY / 3;
    const at = place(event);
    writePose(zoomed(start, Math.exp(Math.max(-1, Math.min(1, lines)) * 0.16), pointUnder(start, at.x, at.y)));
  };

  const onDoubleClick = (event: MouseEvent) => {
    const pixel = wholePixel(place(event));
    if (pixel && !pointerTool.peek()) {
      void targetAt(pixel);
    }
  };

  const onKey = (event: KeyboardEvent) => {
    if (event.target === element && handleKey(event, pause)) {
      event.preventDefault();
    }
  };
  const onLeave = () => (hoveredPixel.value = undefined);
  const onMenu = (event: Event) => event.preventDefault();

  const listeners: [string, EventListener, AddEventListenerOptions?][] = [
    ["pointerdown", onDown as EventListener],
    ["pointermove", onMove as EventListener],
    ["pointerup", onUp as EventListener],
    ["pointercancel", onUp as EventListener],
    ["pointerleave", onLeave],
    ["wheel", onWheel as EventListener, { passive: false }],
    ["dblclick", onDoubleClick as EventListener],
    ["keydown", onKey as EventListener],
    ["contextmenu", onMenu],
  ];
  for (const [name, listener, how] of listeners) {
    element.addEventListener(name, listener, how);
  }
  return () => {
    for (const [name, listener] of listeners) {
      element.removeEventListener(name, listener);
    }
    endDrag?.();
  };
}
