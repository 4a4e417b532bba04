// How a light fades: f over the distance, and of a spot s over the angle from its axis. For the Lights panel and for Explain.
import { Curve } from "./curve";
import { attenuationAt, coneOf, falloffOf, hasCone, hasFalloff, reachOf, spotAt } from "./falloff";
import { numberText } from "./number";
import { plotWords } from "./words";
import "./plots.css";

export interface FalloffPlotProps {
  /** the light's table as a scene file states it, with its `type` */
  light: Record<string, unknown>;
  /** a point's distance from the light, to be marked */
  distance?: number;
  /** a point's angle from the light's axis, degrees, to be marked */
  angle?: number;
  /** the curve reaches at least so far: the scene's size, say */
  reach?: number;
}

export function FalloffPlot({ light, distance, angle, reach = 0 }: FalloffPlotProps) {
  const t = plotWords.value;
  if (!hasFalloff(light)) {
    return null;
  }
  const falloff = falloffOf(light);
  const f = (d: number) => attenuationAt(falloff, d);
  const end = reachOf(falloff, Math.max(reach, (distance ?? 0) * 1.25));
  const nearest = f(end / 160);
  const top =
    falloff.unclamped && nearest > 1 ? Math.max(1, Math.min(nearest, distance === undefined ? 2 : Math.max(2, f(distance) * 1.5))) : 1;
  const said = distance === undefined ? "" : t.falloffAt(numberText(distance, 3), numberText(f(distance), 3));
  const cone = coneOf(light);
  const s = (degrees: number) => spotAt(cone, degrees);
  const widest = Math.min(90, Math.max(cone.cutoff * 1.25, angle ?? 0));
  const saidAngle = angle === undefined ? "" : t.falloffAt(`${numberText(angle, 3)}°`, numberText(s(angle), 3));
  return (
    <div class="falloff-plots">
      <Curve
        value={f}
        end={end}
        top={top}
        title={`f(d), d = ${t.distance}`}
        unit=""
        label={t.falloff(numberText(end, 3), said)}
        testId="falloff"
        {...(distance === undefined ? {} : { mark: distance })}
        {...(falloff.range === undefined ? {} : { corners: [falloff.range] })}
      />
      {hasCone(light) ? (
        <Curve
          value={s}
          end={widest}
          top={1}
          title={`s(θ), θ = ${t.angle}`}
          unit="°"
          label={t.cone(numberText(cone.cutoff), saidAngle)}
          testId="cone"
          corners={cone.beam === undefined ? [cone.cutoff] : [cone.beam, cone.cutoff]}
          {...(angle === undefined ? {} : { mark: angle })}
        />
      ) : null}
    </div>
  );
}
