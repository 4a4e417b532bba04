// The profile: how bright the picture is along the line, for this picture or for the three interpolations at once, with the pixels themselves
// below the curves.
import { useEffect, useLayoutEffect, useMemo, useRef } from "preact/hooks";
import type { Picture } from "../engine/types";
import { kPlotLeft, kPlotRight, LinePlot, type LineSeries } from "../plots/line-plot";
import { numberText } from "../plots/number";
import { fullSize, isPictureFinal } from "../state/picture";
import { selectedPixel } from "../state/selection";
import { pointerTool } from "../state/slots";
import { kLineTool, placeOfPixel, removeLine } from "./line-tool";
import { differenceOf, placesAlong, stripOf, valuesAt, type ProfilePlace } from "./profile";
import { isMeasuring, kInterpolations, profilePictures, startMeasuring, type Shown } from "./profile-pictures";
import { isProfileComparing, isProfileEncoded, profileCalls, profileCursor, profileLine } from "./state";
import { explainWords } from "./words";

const kLooks: Record<(typeof kInterpolations)[number], Pick<LineSeries, "color" | "dash" | "width">> = {
  flat: { color: "--plot-flat", dash: [2, 3], width: 1.6 },
  gouraud: { color: "--plot-gouraud", dash: [7, 3], width: 1.6 },
  phong: { color: "--plot-phong", width: 1.8 },
};

/** The pixels along the line, drawn out to a strip as wide as the plot. */
function Strip({ picture, places, name }: { picture: Picture; places: readonly ProfilePlace[]; name: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current!;
    element.width = places.length;
    element.height = 1;
    element.getContext("2d")?.putImageData(new ImageData(stripOf(picture.bytes, picture.width, places), places.length, 1), 0, 0);
  }, [picture, places]);
  return (
    <div class="x-strip" style={{ paddingRight: `${kPlotRight}px` }}>
      <span style={{ width: `${kPlotLeft}px` }}>{name}</span>
      <canvas ref={canvas} aria-hidden="true" />
    </div>
  );
}

const extent = (values: readonly number[]) => ({
  low: values.reduce((a, b) => Math.min(a, b), Infinity),
  high: values.reduce((a, b) => Math.max(a, b), -Infinity),
});

function Current({ picture, places }: { picture: Picture; places: readonly ProfilePlace[] }) {
  const t = explainWords.value;
  const encoded = isProfileEncoded.value;
  const values = useMemo(() => valuesAt(picture.floats!, picture.width, places, encoded), [picture, places, encoded]);
  const x = useMemo(() => places.map(({ distance }) => distance), [places]);
  const series: LineSeries[] = useMemo(
    () => [
      { label: t.red, values: values.channels[0], color: "--plot-red", width: 1.1, dash: [7, 3] },
      { label: t.green, values: values.channels[1], color: "--plot-green", width: 1.1, dash: [4, 2] },
      { label: t.blue, values: values.channels[2], color: "--plot-blue", width: 1.1, dash: [2, 2] },
      { label: t.luminance, values: values.luminance, color: "--plot-luminance", width: 2 },
    ],
    [values, t],
  );
  const { low, high } = extent(values.luminance);
  return (
    <>
      <LinePlot
        x={x}
        series={series}
        height={190}
        xLabel={t.alongLine}
        label={t.profileLabel(numberText(x.at(-1)!, 3), numberText(low, 3), numberText(high, 3))}
        testId="profile-plot"
        onCursor={(index) => (profileCursor.value = index === undefined ? undefined : index / Math.max(1, places.length - 1))}
      />
      <Strip picture={picture} places={places} name="" />
    </>
  );
}

function Compared({ pictures, places }: { pictures: Record<(typeof kInterpolations)[number], Picture>; places: readonly ProfilePlace[] }) {
  const t = explainWords.value;
  const encoded = isProfileEncoded.value;
  const curves = useMemo(
    () =>
      kInterpolations.map((name) => ({ name, values: valuesAt(pictures[name].floats!, pictures[name].width, places, encoded).luminance })),
    [pictures, places, encoded],
  );
  const x = useMemo(() => places.map(({ distance }) => distance), [places]);
  const series = useMemo(
    () => curves.map(({ name, values }): LineSeries => ({ label: t.interpolations[name], values, ...kLooks[name] })),
    [curves, t],
  );
  const differences = useMemo(
    () => curves.slice(0, 2).map(({ name, values }) => ({ name, ...differenceOf(values, curves[2]!.values) })),
    [curves],
  );
  const differenceSeries = useMemo(
    () =>
      differences.map(({ name, values }): LineSeries => ({
        label: `${t.interpolations[name]} − ${t.interpolations.phong}`,
        values,
        ...kLooks[name],
      })),
    [differences, t],
  );
  const onCursor = (index: number | undefined) =>
    (profileCursor.value = index === undefined ? undefined : index / Math.max(1, places.length - 1));
  const said = differences
    .map(({ name, largest, rms }) => `${t.interpolations[name]}: ${t.largest} ${numberText(largest, 3)}, ${t.rms} ${numberText(rms, 3)}`)
    .join("; ");
  const { low, high } = extent(curves[2]!.values);
  return (
    <>
      <LinePlot
        x={x}
        series={series}
        height={190}
        xLabel={t.alongLine}
        label={t.profileLabel(numberText(x.at(-1)!, 3), numberText(low, 3), numberText(high, 3))}
        testId="profile-plot"
        onCursor={onCursor}
      />
      {kInterpolations.map((name) => (
        <Strip key={name} picture={pictures[name]} places={places} name={t.interpolations[name]} />
      ))}
      <h4>{t.difference}</h4>
      <LinePlot
        x={x}
        series={differenceSeries}
        height={140}
        xLabel={t.alongLine}
        label={`${t.difference}. ${said}`}
        testId="profile-difference"
        onCursor={onCursor}
      />
      <table class="x-triples" aria-label={t.difference} data-testid="profile-errors">
        <thead>
          <tr>
            <td />
            <th scope="col">{t.largest}</th>
            <th scope="col">{t.rms}</th>
          </tr>
        </thead>
        <tbody>
          {differences.map(({ name, largest, rms }) => (
            <tr key={name}>
              <th scope="row">{t.interpolations[name]}</th>
              <td>{numberText(largest, 3)}</td>
              <td>{numberText(rms, 3)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="x-note">{t.machBands}</p>
    </>
  );
}

function Plots() {
  const t = explainWords.value;
  const line = profileLine.value!;
  const pictures = profilePictures.value;
  const { width, height } = fullSize.value;
  const places = useMemo(() => placesAlong(line, width, height), [line, width, height]);
  const fits = (shown: Shown) => pictures[shown]?.width === width && pictures[shown].height === height;
  if (isProfileComparing.value && kInterpolations.every(fits)) {
    return <Compared pictures={pictures as Record<(typeof kInterpolations)[number], Picture>} places={places} />;
  }
  if (!isProfileComparing.value && fits("current")) {
    return <Current picture={pictures.current!} places={places} />;
  }
  return <p class="x-note">{isMeasuring.value || !isPictureFinal.value ? `${t.measuring} …` : ""}</p>;
}

function Ends() {
  const t = explainWords.value;
  const pixel = selectedPixel.value;
  const line = profileLine.value;
  const setEnd = (end: "from" | "to") => {
    const place = placeOfPixel(pixel!);
    const opposite = { x: place.x < 0.5 ? place.x + 0.3 : place.x - 0.3, y: place.y };
    profileLine.value = { from: opposite, to: opposite, ...line, [end]: place };
  };
  return (
    <div class="x-buttons">
      <button
        class="action"
        type="button"
        aria-pressed={pointerTool.value?.id === kLineTool.id}
        onClick={() => (pointerTool.value = kLineTool)}
        data-testid="draw-line"
      >
        {t.drawLine}
      </button>
      <button class="action" type="button" disabled={!pixel} onClick={() => setEnd("from")} data-testid="line-start-here">
        {t.startHere}
      </button>
      <button class="action" type="button" disabled={!pixel} onClick={() => setEnd("to")} data-testid="line-end-here">
        {t.endHere}
      </button>
      {line ? (
        <button class="action" type="button" onClick={removeLine} data-testid="line-remove">
          {t.removeLine}
        </button>
      ) : null}
    </div>
  );
}

export function ProfileView() {
  const t = explainWords.value;
  const section = useRef<HTMLDetailsElement>(null);
  const line = profileLine.value;
  useEffect(() => startMeasuring(), []);
  // To the plot that was called for, and once more when it is there.
  const seen = useRef(profileCalls.peek() - (line ? 1 : 0));
  useEffect(() => {
    if (profileCalls.value > seen.current && section.current) {
      section.current.open = true;
      section.current.scrollIntoView({ block: "start" });
      if (Object.keys(profilePictures.value).length > 0) {
        seen.current = profileCalls.value;
      }
    }
  }, [profileCalls.value, profilePictures.value]);
  return (
    <details class="x-section" open={line !== undefined} ref={section} data-testid="explain-profile">
      <summary>{t.profile}</summary>
      <div class="x-body">
        {line ? (
          <div class="x-modes">
            <label>
              <input
                type="radio"
                name="profile-mode"
                checked={!isProfileComparing.value}
                onChange={() => (isProfileComparing.value = false)}
                data-testid="profile-current"
              />{" "}
              {t.current}
            </label>
            <label>
              <input
                type="radio"
                name="profile-mode"
                checked={isProfileComparing.value}
                onChange={() => (isProfileComparing.value = true)}
                data-testid="profile-compare"
              />{" "}
              {t.compareShading}
            </label>
            <label>
              <input
                type="checkbox"
                checked={isProfileEncoded.value}
                onChange={(event) => (isProfileEncoded.value = event.currentTarget.checked)}
                data-testid="profile-encoded"
              />{" "}
              {t.encodedScale}
            </label>
          </div>
        ) : (
          <p class="x-note">{t.profileHelp}</p>
        )}
        {line ? <Plots /> : null}
        <Ends />
      </div>
    </details>
  );
}
