// A slider; while it is held the change is one gesture.
import { useRef } from "preact/hooks";
import { beginDrag, pausingDrag } from "../state/scene";
import { fromShare, toShare, type SliderRange } from "./defaults";

export interface SliderProps {
  label: string;
  value: number;
  range: SliderRange;
  isInteger?: boolean;
  isAllowed: (value: number) => boolean;
  onValue: (value: number) => void;
  testid?: string;
}

const kSteps = 1000;
const kArrows: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };

/** Three or four digits are what a slider can mean. */
function readable(value: number, { from, to, scale }: SliderRange): number {
  if (scale === "log") {
    return Number(value.toPrecision(3));
  }
  const step = 10 ** Math.floor(Math.log10((to - from) / 200));
  return Number((Math.round(value / step) * step).toPrecision(10));
}

export function Slider({ label, value, range, isInteger, isAllowed, onValue, testid }: SliderProps) {
  const end = useRef<(() => void) | undefined>(undefined);
  const pause = useRef(pausingDrag());
  const finish = () => {
    end.current?.();
    end.current = undefined;
  };
  // Of whole numbers the next one may be many steps of the slider away: arrows would never reach it.
  const onKeyDown = (event: KeyboardEvent) => {
    const next = value + (kArrows[event.key] ?? 0);
    if (isInteger && next !== value) {
      event.preventDefault();
      if (next >= range.from && next <= range.to && isAllowed(next)) {
        pause.current();
        onValue(next);
      }
    }
  };
  return (
    <input
      class="slider"
      type="range"
      min={0}
      max={kSteps}
      step={1}
      aria-label={label}
      aria-valuetext={String(value)}
      value={Math.round(toShare(range, value) * kSteps)}
      style={{ "--share": `${toShare(range, value) * 100}%` }}
      data-testid={testid}
      onPointerDown={() => (end.current ??= beginDrag())}
      onPointerUp={finish}
      onPointerCancel={finish}
      onBlur={finish}
      onKeyDown={onKeyDown}
      onInput={(event) => {
        pause.current();
        const next = readable(fromShare(range, Number(event.currentTarget.value) / kSteps), range);
        const whole = isInteger ? Math.round(next) : next;
        if (isAllowed(whole)) {
          onValue(whole);
        }
      }}
    />
  );
}
