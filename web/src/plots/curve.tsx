// A small plot of one curve: axes with a few ticks, a line, perhaps a marked point. It is as wide as its place.
import { line } from "d3-shape";
import { numberText } from "./number";

/** Round steps, at most `most` of them, that reach the end. */
export function ticks(end: number, most: number): number[] {
  if (!(end > 0)) {
    return [0];
  }
  const rough = end / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10) * power;
  return Array.from({ length: Math.floor(end / step + 1e-9) + 1 }, (_, i) => Number((i * step).toPrecision(10)));
}

const kWidth = 168;
const kHeight = 96;
const kLeft = 26;
const kBottom = 20;
const kTop = 14;
const kRight = 8;

export interface CurveProps {
  /** at x = 0 .. end */
  value: (x: number) => number;
  end: number;
  top: number;
  /** `f(d)` */
  title: string;
  unit: string;
  label: string;
  mark?: number;
  /** places where the curve jumps or bends: it is drawn exactly there */
  corners?: readonly number[];
  testId: string;
}

/** Points of the curve: even steps, and both sides of every corner. */
export function curvePoints(value: (x: number) => number, end: number, corners: readonly number[] = []): [number, number][] {
  const kSteps = 160;
  const sides = corners.flatMap((x) => [x * (1 - 1e-9), x * (1 + 1e-9)]).filter((x) => x >= 0 && x <= end);
  const places = [...Array.from({ length: kSteps + 1 }, (_, i) => (end * i) / kSteps), ...sides].sort((a, b) => a - b);
  return places.map((x) => [x, value(x)]);
}

export function Curve({ value, end, top, title, unit, label, mark, corners, testId }: CurveProps) {
  const x = (at: number) => kLeft + (at / end) * (kWidth - kLeft - kRight);
  const y = (at: number) => kHeight - kBottom - (Math.min(at, top * 1.02) / top) * (kHeight - kBottom - kTop);
  const path = line<[number, number]>()
    .x((point) => x(point[0]))
    .y((point) => y(point[1]))(curvePoints(value, end, corners));
  const isMarked = mark !== undefined && mark <= end;
  return (
    <svg class="small-plot" viewBox={`0 0 ${kWidth} ${kHeight}`} role="img" aria-label={label} data-testid={testId}>
      {ticks(top, 2).map((at) => (
        <g key={at}>
          <line class="small-plot-grid" x1={kLeft} x2={kWidth - kRight} y1={y(at)} y2={y(at)} />
          <text class="small-plot-tick" x={kLeft - 4} y={y(at) + 3} text-anchor="end">
            {numberText(at)}
          </text>
        </g>
      ))}
      {ticks(end, 4).map((at) => (
        <text key={at} class="small-plot-tick" x={x(at)} y={kHeight - kBottom + 12} text-anchor="middle">
          {numberText(at)}
          {unit}
        </text>
      ))}
      <text class="small-plot-title" x={kLeft} y={9}>
        {title}
      </text>
      {isMarked ? <line class="small-plot-mark" x1={x(mark)} x2={x(mark)} y1={y(0)} y2={y(value(mark))} /> : null}
      <path class="small-plot-line" d={path ?? ""} />
      {isMarked ? <circle class="small-plot-point" cx={x(mark)} cy={y(value(mark))} r="3" /> : null}
    </svg>
  );
}
