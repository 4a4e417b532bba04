// Curves over one axis by uPlot: as wide as its place, in the page's colours, with a cursor by pointer and by arrow keys.
import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { isDark } from "../state/settings";
import { numberText } from "./number";

/** Where the plotting area begins and ends, so that something below can be aligned with it. CSS pixels. */
export const kPlotLeft = 48;
export const kPlotRight = 10;

export interface LineSeries {
  label: string;
  values: readonly number[];
  /** a custom property: `--plot-red` */
  color: string;
  dash?: number[];
  width?: number;
}

export interface LinePlotProps {
  x: readonly number[];
  series: readonly LineSeries[];
  height: number;
  label: string;
  xLabel: string;
  testId: string;
  /** the index under the cursor */
  onCursor?: (index: number | undefined) => void;
}

function optionsOf(
  { series, height, xLabel }: LinePlotProps,
  element: HTMLElement,
  cursor: (index: number | undefined) => void,
): uPlot.Options {
  const css = getComputedStyle(element);
  const color = (name: string) => css.getPropertyValue(name).trim();
  const axis: uPlot.Axis = {
    stroke: color("--plot-ink"),
    grid: { stroke: color("--plot-grid"), width: 1 },
    ticks: { stroke: color("--plot-grid"), width: 1, size: 4 },
    font: `10px ${css.fontFamily}`,
  };
  return {
    width: Math.max(120, element.clientWidth),
    height,
    padding: [8, kPlotRight, 0, 0],
    scales: { x: { time: false } },
    cursor: { drag: { x: false, y: false }, points: { size: 6 } },
    legend: { live: true },
    axes: [
      { ...axis, size: 24, values: (_, at) => at.map((value) => numberText(value)) },
      { ...axis, size: kPlotLeft, space: 24, values: (_, at) => at.map((value) => numberText(value)) },
    ],
    series: [
      { label: xLabel, value: (_, value) => (value === null ? "–" : numberText(value, 4)) },
      ...series.map((one): uPlot.Series => ({
        label: one.label,
        stroke: color(one.color),
        width: one.width ?? 1.5,
        points: { show: false },
        value: (_, value) => (value === null ? "–" : numberText(value, 4)),
        ...(one.dash ? { dash: one.dash } : {}),
      })),
    ],
    hooks: { setCursor: [(plot) => cursor(plot.cursor.idx ?? undefined)] },
  };
}

const dataOf = ({ x, series }: LinePlotProps): uPlot.AlignedData => [[...x], ...series.map(({ values }) => [...values])];

export function LinePlot(props: LinePlotProps) {
  const place = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot>(undefined);
  const latest = useRef(props);
  latest.current = props;
  const looks = `${isDark.value} ${props.height} ${props.xLabel} ${props.series.map(({ label, color }) => label + color).join(" ")}`;

  useEffect(() => {
    const element = place.current!;
    // After the page has the theme's colours: app.tsx sets it in an effect of its own.
    const made = new uPlot(
      optionsOf(latest.current, element, (index) => latest.current.onCursor?.(index)),
      dataOf(latest.current),
      element,
    );
    plot.current = made;
    const observer = new ResizeObserver(() => made.setSize({ width: Math.max(120, element.clientWidth), height: latest.current.height }));
    observer.observe(element);
    return () => {
      observer.disconnect();
      made.destroy();
      plot.current = undefined;
    };
  }, [looks]);

  useEffect(() => plot.current?.setData(dataOf(latest.current)), [props.x, props.series]);

  const onKey = (event: KeyboardEvent) => {
    const step = { ArrowLeft: -1, ArrowRight: 1, PageUp: -20, PageDown: 20, Home: -Infinity, End: Infinity }[event.key];
    const current = plot.current;
    const last = props.x.length - 1;
    if (step !== undefined && current && last > 0) {
      const index = Math.min(last, Math.max(0, (current.cursor.idx ?? 0) + step));
      current.setCursor({ left: current.valToPos(props.x[index]!, "x"), top: 0 });
      event.preventDefault();
    }
  };
  return (
    <div class="line-plot" tabIndex={0} onKeyDown={onKey} data-testid={props.testId} role="group" aria-label={props.label}>
      <div ref={place} />
    </div>
  );
}
