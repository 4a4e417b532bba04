// What is drawn over the picture at the chosen pixel: N, L, V, R and H as arrows, the ways to the lights, the triangle with its vertex normals.
import type { LightInfo, Vec3 } from "../engine/types";
import { pictureRect, project } from "../stage/projection";
import { lightsShown, view } from "../state/picture";
import { panelTab } from "../state/settings";
import { hasHighlight } from "./equation";
import { arrowLength, arrowOf, spreadLabels, type Arrow, type Project } from "./overlay-math";
import { drawn, shownExplanation, subject, type Subject } from "./state";

type Letter = "N" | "L" | "V" | "R" | "H";

/** Arrows as a share of the picture's smaller side. */
const kArrowShare = 0.17;

function vectorsOf({ fragment, shading, light }: Subject): [Letter, Vec3][] {
  const l = shading.lights[light];
  const vectors: [Letter, Vec3][] = [
    ["N", shading.normal],
    ["V", shading.to_eye],
  ];
  if (l) {
    vectors.push(["L", l.to_light]);
    if (fragment.lighting === "phong" && l.n_dot_l > 0) {
      vectors.push(["R", l.reflected]);
    } else if (hasHighlight(fragment) && fragment.lighting !== "phong") {
      vectors.push(["H", l.half]);
    }
  }
  return vectors.filter(([name]) => drawn.value[name]);
}

function ArrowShape({ name, arrow, label }: { name: Letter; arrow: Arrow; label: { x: number; y: number } }) {
  const { from, to } = arrow;
  const angle = (Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI;
  return (
    <g class={`x-arrow x-arrow-${name}`} data-testid={`arrow-${name}`}>
      {arrow.isEndOn ? (
        <circle cx={to.x} cy={to.y} r="5" />
      ) : (
        <>
          <path d={`M${from.x} ${from.y}L${to.x} ${to.y}`} />
          <path class="x-head" d="M0 0L-11 -4.500L-11 4.500Z" transform={`translate(${to.x} ${to.y}) rotate(${angle})`} />
        </>
      )}
      <text x={label.x} y={label.y + 4} text-anchor="middle">
        {name}
      </text>
    </g>
  );
}

/** Towards each light: to its place, or for a directional one far along its direction. */
function LightWays({ at, lights, length, to }: { at: Vec3; lights: readonly (LightInfo | undefined)[]; length: number; to: Project }) {
  const { shading, light: chosen } = subject.value!;
  const from = to(at)!;
  return (
    <g class="x-ways">
      {shading.lights.map((l, i) => {
        const info = lights[l.light];
        const end: Vec3 =
          l.distance > 0
            ? ([0, 1, 2].map((axis) => at[axis]! + l.to_light[axis]! * l.distance) as Vec3)
            : ([0, 1, 2].map((axis) => at[axis]! + l.to_light[axis]! * length * 6) as Vec3);
        const there = to(end);
        return there ? (
          <g key={l.light} class={`x-way${i === chosen ? " chosen" : ""}${l.n_dot_l <= 0 ? " behind" : ""}`} data-testid="way-to-light">
            <path d={`M${from.x} ${from.y}L${there.x} ${there.y}`} />
            {l.distance > 0 ? <circle cx={there.x} cy={there.y} r="4" /> : null}
            {info?.name ? (
              <text x={there.x + 7} y={there.y - 5}>
                {info.name}
              </text>
            ) : null}
          </g>
        ) : null;
      })}
    </g>
  );
}

function Triangle({ corners, normals, length, to }: { corners: Vec3[]; normals: Vec3[]; length: number; to: Project }) {
  const places = corners.map((corner) => to(corner));
  if (places.some((place) => !place)) {
    return null;
  }
  return (
    <g class="x-triangle" data-testid="explain-triangle">
      <polygon points={places.map((place) => `${place!.x},${place!.y}`).join(" ")} />
      {normals.map((normal, i) => {
        const arrow = arrowOf(to, corners[i]!, normal, length * 0.55);
        return arrow ? <path key={i} class="x-vertex-normal" d={`M${arrow.from.x} ${arrow.from.y}L${arrow.to.x} ${arrow.to.y}`} /> : null;
      })}
      {places.map((place, i) => (
        <circle key={i} cx={place!.x} cy={place!.y} r="2.5" />
      ))}
    </g>
  );
}

export function VectorOverlay() {
  const current = subject.value;
  const v = view.value;
  const to = project.value;
  const { width, height } = pictureRect.value;
  if (!current || !v || width === 0 || panelTab.value !== "explain" || !to(current.shading.position)) {
    return null;
  }
  const at = current.shading.position;
  const length = arrowLength(to, at, v.right, Math.min(width, height) * kArrowShare);
  const arrows = vectorsOf(current).flatMap(([name, direction]) => {
    const arrow = arrowOf(to, at, direction, length);
    return arrow ? [{ name, arrow }] : [];
  });
  const labels = spreadLabels(arrows.map(({ arrow }) => arrow.label));
  const triangle = shownExplanation.value?.triangle;
  return (
    <g class="x-overlay" data-testid="explain-overlay">
      {drawn.value.triangle && triangle ? (
        <Triangle corners={triangle.positions} normals={triangle.normals} length={length} to={to} />
      ) : null}
      {drawn.value.lights ? <LightWays at={at} lights={lightsShown.value} length={length} to={to} /> : null}
      {arrows.map(({ name, arrow }, i) => (
        <ArrowShape key={name} name={name} arrow={arrow} label={labels[i]!} />
      ))}
    </g>
  );
}
