// Two pictures in one place: the left one up to the wipe, the right one from there on; or both beside each other. The
// right one lies above the stage's own.
import { signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { wipe } from "../state/compare";
import { words } from "./words";

/** `side`: both pictures, smaller; `wipe`: one picture, whose parts come from both. */
export const splitLayout = signal<"wipe" | "side">("wipe");

interface SplitProps {
  leftLabel: string;
  rightLabel: string;
  /** the right picture, a canvas as large as the layer */
  children: ComponentChildren;
  /** the left picture, where it is not the stage's own; asked for by `side` */
  left?: ComponentChildren;
}

const kStep = 0.02;

function clamped(value: number): number {
  return Math.min(1, Math.max(0, value));
}

function WipeHandle() {
  const bar = useRef<HTMLDivElement>(null);
  const follow = (event: PointerEvent) => {
    const box = bar.current!.parentElement!.getBoundingClientRect();
    wipe.value = clamped((event.clientX - box.left) / box.width);
  };
  return (
    <div
      ref={bar}
      class="wipe-handle"
      style={{ left: `${wipe.value * 100}%` }}
      role="slider"
      tabIndex={0}
      aria-label={words.value.wipe}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(wipe.value * 100)}
      data-testid="wipe"
      onPointerDown={(event) => {
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) {
          event.stopPropagation();
          follow(event);
        }
      }}
      onKeyDown={(event) => {
        const step =
          event.key === "ArrowLeft" ? -kStep : event.key === "ArrowRight" ? kStep : event.key === "Home" ? -1 : event.key === "End" ? 1 : 0;
        if (step !== 0) {
          event.preventDefault();
          event.stopPropagation();
          wipe.value = clamped(wipe.value + step);
        }
      }}
    />
  );
}

export function Split({ leftLabel, rightLabel, children, left }: SplitProps) {
  const isSide = splitLayout.value === "side" && left !== undefined;
  const at = isSide ? 0.5 : wipe.value;
  return (
    <div class={`split ${isSide ? "split-side" : "split-wipe"}`} data-testid="split">
      {isSide && <div class="split-pane split-left">{left}</div>}
      <div class="split-pane split-right" style={isSide ? {} : { clipPath: `inset(0 0 0 ${at * 100}%)` }}>
        {children}
      </div>
      <span class="split-label" style={{ right: `calc(${(1 - at) * 100}% + 0.6rem)` }} data-testid="split-left-label">
        {leftLabel}
      </span>
      <span class="split-label" style={{ left: `calc(${at * 100}% + 0.6rem)` }} data-testid="split-right-label">
        {rightLabel}
      </span>
      {isSide ? <div class="split-seam" /> : <WipeHandle />}
    </div>
  );
}
