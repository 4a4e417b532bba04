// The specular lobe as a polar plot around the surface's point, with N, L, R, H and the eye V that looks now.
import { lineRadial } from "d3-shape";
import type { Vec3 } from "../engine/types";
import { inPlane, lobeCurve, lobeValue, planeOf, type LobeSurface, type PlaneVector } from "./lobe";
import { numberText } from "../plots/number";
import { plotWords } from "../plots/words";

const kWidth = 340;
const kHeight = 206;
const kRadius = 146;
const kX = kWidth / 2;
const kY = kHeight - 22;

const placeOf = (angle: number, radius: number) => ({ x: Math.sin(angle) * radius, y: -Math.cos(angle) * radius });

/** Labels of rays that nearly lie on each other stand behind each other. */
function labelRadii(vectors: readonly PlaneVector[]): number[] {
  return vectors.map((vector, i) => {
    const tip = placeOf(vector.angle, kRadius * vector.length);
    const near = vectors.slice(0, i).filter((other) => {
      const place = placeOf(other.angle, kRadius * other.length);
      return Math.hypot(place.x - tip.x, place.y - tip.y) < 14;
    });
    return kRadius * vector.length + 10 + 13 * near.length;
  });
}

function Ray({ name, vector, labelAt, isDashed }: { name: string; vector: PlaneVector; labelAt: number; isDashed: boolean }) {
  const tip = placeOf(vector.angle, kRadius * vector.length);
  const label = placeOf(vector.angle, labelAt);
  return (
    <g class={`lobe-ray lobe-${name}`} data-testid={`lobe-${name}`}>
      <line x2={tip.x} y2={tip.y} stroke-dasharray={isDashed ? "4 3" : undefined} />
      <text x={label.x} y={label.y + 3.5} text-anchor="middle">
        {name}
      </text>
    </g>
  );
}

export function LobePlot({ surface, toEye, half }: { surface: LobeSurface; toEye: Vec3; half: Vec3 }) {
  const t = plotWords.value;
  const plane = planeOf(surface.normal, surface.toLight, toEye);
  const curve = lobeCurve(surface, plane);
  const atEye = lobeValue(surface, toEye);
  const peak = Math.max(...curve.map(({ value }) => value), atEye);
  const scale = peak > 0 ? kRadius / peak : 0;
  const path = lineRadial<{ angle: number; value: number }>()
    .angle(({ angle }) => angle)
    .radius(({ value }) => value * scale)(curve);
  const light = inPlane(plane, surface.toLight);
  const eye = inPlane(plane, toEye);
  const rays: { name: string; vector: PlaneVector }[] = [
    { name: "N", vector: { angle: 0, length: 1, outside: 0 } },
    { name: "L", vector: light },
    surface.lighting === "phong" ? { name: "R", vector: { ...light, angle: -light.angle } } : { name: "H", vector: inPlane(plane, half) },
    { name: "V", vector: eye },
  ];
  const radii = labelRadii(rays.map(({ vector }) => vector));
  const seen = placeOf(eye.angle, atEye * scale);
  const formula = { phong: "(R·V)ⁿ", "blinn-phong": "(N·H)ⁿ", ggx: "F D Vis N·L" }[surface.lighting] ?? "";
  return (
    <svg
      class="lobe"
      viewBox={`0 0 ${kWidth} ${kHeight}`}
      role="img"
      aria-label={t.lobe(formula, numberText(surface.n), numberText(atEye), numberText(peak))}
      data-testid="lobe"
    >
      <g transform={`translate(${kX} ${kY})`}>
        {[0.25, 0.5, 0.75, 1].map((share) => (
          <g key={share}>
            <path class="lobe-ring" d={`M${-kRadius * share} 0A${kRadius * share} ${kRadius * share} 0 0 1 ${kRadius * share} 0`} />
            <text class="lobe-tick" x={kRadius * share} y="12" text-anchor="middle">
              {numberText(peak * share, 3)}
            </text>
          </g>
        ))}
        <line class="lobe-ground" x1={-kRadius - 14} x2={kRadius + 14} />
        <path class="lobe-shape" d={path ?? ""} />
        {rays.map(({ name, vector }, i) => (
          <Ray key={name} name={name} vector={vector} labelAt={radii[i]!} isDashed={name === "V" && vector.outside > 1} />
        ))}
        <circle class="lobe-eye" cx={seen.x} cy={seen.y} r="4" />
      </g>
    </svg>
  );
}
