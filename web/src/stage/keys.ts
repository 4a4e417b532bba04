// The stage's keys: arrows turn (shift: move, alt: in small steps), + and - zoom, F frames, 1, 3, 7 and with shift their opposites are views,
// 5 changes the projection, Enter reads the pixel in the middle, alt and arrows walk it.
import { fullSize, view } from "../state/picture";
import { selectedPixel } from "../state/selection";
import { currentPose, frameAll, orbited, panned, setProjection, showPreset, writePose, zoomed } from "./camera";
import { length, subtract } from "./vector";

const kArrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const kViews: Record<string, [string, string]> = { Digit1: ["front", "back"], Digit3: ["right", "left"], Digit7: ["top", "bottom"] };
const kStepRadians = (5 * Math.PI) / 180;
const kZoomStep = 1.15;

function walkPixel(x: number, y: number): void {
  const full = fullSize.peek();
  const before = selectedPixel.peek() ?? { x: Math.floor(full.width / 2), y: Math.floor(full.height / 2) };
  selectedPixel.value = {
    x: Math.max(0, Math.min(full.width - 1, before.x + x)),
    y: Math.max(0, Math.min(full.height - 1, before.y - y)),
  };
}

/** Whether the key was one of the stage's. pause  begins a gesture that ends by itself */
export function handleKey(event: KeyboardEvent, pause: () => void): boolean {
  if (event.ctrlKey || event.metaKey) {
    return false;
  }
  const arrow = kArrows[event.key];
  if (arrow && event.altKey) {
    const step = event.shiftKey ? 10 : 1;
    walkPixel(arrow[0] * step, arrow[1] * step);
    return true;
  }
  const views = kViews[event.code.replace("Numpad", "Digit")];
  if (views) {
    showPreset(event.shiftKey ? views[1] : views[0]);
    return true;
  }
  switch (event.key) {
    case "f":
    case "F":
      frameAll();
      return true;
    case "Home":
      showPreset("three-quarter");
      return true;
    case "5":
      setProjection(view.peek()?.projection === "orthographic" ? "perspective" : "orthographic");
      return true;
    case "Enter":
    case " ":
      walkPixel(0, 0);
      return true;
    case "Escape":
      selectedPixel.value = undefined;
      return true;
  }
  const pose = currentPose();
  const zoom = event.key === "+" || event.key === "=" ? 1 / kZoomStep : event.key === "-" || event.key === "_" ? kZoomStep : undefined;
  if (!pose || (!arrow && zoom === undefined)) {
    return false;
  }
  pause();
  if (zoom !== undefined) {
    writePose(zoomed(pose, zoom));
  } else if (arrow && event.shiftKey) {
    const step = (pose.projection === "orthographic" ? pose.height : length(subtract(pose.eye, pose.target))) * 0.04;
    writePose(panned(pose, arrow[0] * step, arrow[1] * step));
  } else if (arrow) {
    writePose(orbited(pose, arrow[0] * kStepRadians, arrow[1] * kStepRadians));
  }
  return true;
}
