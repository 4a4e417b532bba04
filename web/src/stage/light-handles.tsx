// The lights in the view: each where it stands, to be dragged parallel to the screen; of the chosen one also where it shines, its cone or its
// area. A directional light stands for itself on a ball around the scene.
import { signal } from "@preact/signals";
import { words } from "../i18n";
import { lightLabel } from "../controls/light-panel";
import { readColor, screenColor } from "../controls/color";
import type { Vec3 } from "../engine/types";
import {
  directionOf,
  hasDirection,
  hasPosition,
  isDefaultRig,
  lights,
  positionOf,
  typeOf,
  type LightEntry,
  type LightType,
} from "../state/lights";
import { view } from "../state/picture";
import { beginDrag, pausingDrag, update } from "../state/scene";
import { selectedLight } from "../state/selection";
import { panelTab } from "../state/settings";
import { register } from "../state/slots";
import { pictureRect, project, unproject, type PlacedPoint } from "./projection";
import { add, cross, dot, length, rounded, scaled, subtract, unit } from "./vector";

const kKeyPixels = 8;
const kCirclePoints = 48;
const kEdge = 18;

/** The size of the scene and where its middle is; where it goes far beyond what is looked at, of that. */
function reach(): { center: Vec3; radius: number } {
  const v = view.value;
  if (!v) {
    return { center: [0, 0, 0], radius: 1 };
  }
  const whole = length(subtract(v.upper, v.lower)) / 2;
  const seen = 0.45 * length(subtract(v.eye, v.target));
  return whole <= seen ? { center: scaled(add(v.lower, v.upper), 0.5), radius: whole || 1 } : { center: v.target, radius: seen };
}

/** Where a light's mark stands. */
function anchorOf(light: LightEntry): Vec3 {
  if (hasPosition(typeOf(light))) {
    return positionOf(light);
  }
  const { center, radius } = reach();
  return subtract(center, scaled(unit(directionOf(light)), radius));
}

/** How far from it a light's second handle stands. */
function armOf(light: LightEntry): number {
  const { center, radius } = reach();
  const away = length(subtract(center, positionOf(light)));
  return Math.max(radius * 0.3, Math.min(away, radius * 2));
}

/** Two directions at right angles to one and each other; `edge` says which one comes first. */
function axesAround(direction: Vec3, edge?: unknown): [Vec3, Vec3] {
  const d = unit(direction);
  const stated = Array.isArray(edge) && edge.length === 3 ? (edge as Vec3) : undefined;
  const level = cross([0, 1, 0], scaled(d, -1));
  const first = stated ?? (length(level) > 1e-6 ? level : ([1, 0, 0] as Vec3));
  const x = unit(subtract(first, scaled(d, dot(first, d))), [1, 0, 0]);
  return [x, cross(scaled(d, -1), x)];
}

const pathOf = (points: readonly (PlacedPoint | undefined)[], isClosed: boolean): string => {
  let text = "";
  let isPen = false;
  for (const point of points) {
    text += point ? `${isPen ? "L" : "M"}${point.x.toFixed(1)} ${point.y.toFixed(1)}` : "";
    isPen = point !== undefined;
  }
  return isClosed && points.every((point) => point) && text !== "" ? `${text}Z` : text;
};

const circle = (center: Vec3, x: Vec3, y: Vec3, radius: number): Vec3[] =>
  Array.from({ length: kCirclePoints + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / kCirclePoints;
    return add(center, add(scaled(x, radius * Math.cos(angle)), scaled(y, radius * Math.sin(angle))));
  });

/** A mark beyond the picture's edge, or below the stage's tools, stands beside them: it can be fetched from there. */
function insidePicture(place: PlacedPoint): PlacedPoint {
  const { left, top, width, height } = pictureRect.value;
  const x = Math.max(kEdge, Math.min(width - kEdge, place.x));
  const y = Math.max(kEdge, Math.min(height - kEdge, place.y));
  const tools = document.querySelector<HTMLElement>(".stage-tools");
  if (!tools) {
    return { x, y, depth: place.depth };
  }
  const toolsLeft = tools.offsetLeft - left;
  const above = tools.offsetTop - top - kEdge;
  const below = tools.offsetTop + tools.offsetHeight - top + kEdge;
  const isHidden = x > toolsLeft - kEdge && x < toolsLeft + tools.offsetWidth + kEdge && y > above && y < below;
  return { x, y: !isHidden ? y : above + below < height ? below : above, depth: place.depth };
}

interface HandleProps {
  at: PlacedPoint;
  label: string;
  color: string;
  isChosen: boolean;
  kind: LightType | "aim";
  testid: string;
  onMove: (to: Vec3) => void;
  onChoose: () => void;
}

const held = signal("");

/** A mark that can be dragged, or moved by the arrow keys, at its depth. */
function Handle({ at, label, color, isChosen, kind, testid, onMove, onChoose }: HandleProps) {
  const move = (x: number, y: number) => {
    const to = unproject(x, y, at.depth);
    if (to) {
      onMove(to);
    }
  };
  const onPointerDown = (event: PointerEvent) => {
    if (event.button !== 0) {
      return;
    }
    const element = event.currentTarget as SVGElement;
    event.preventDefault();
    onChoose();
    const end = beginDrag();
    const start = { x: event.clientX, y: event.clientY };
    held.value = testid;
    element.setPointerCapture(event.pointerId);
    const depth = at.depth;
    const follow = (next: PointerEvent) => {
      const to = unproject(at.x + next.clientX - start.x, at.y + next.clientY - start.y, depth);
      if (to && (next.clientX !== start.x || next.clientY !== start.y)) {
        onMove(to);
      }
    };
    const finish = () => {
      element.removeEventListener("pointermove", follow);
      element.removeEventListener("pointerup", finish);
      element.removeEventListener("pointercancel", finish);
      held.value = "";
      end();
    };
    element.addEventListener("pointermove", follow);
    element.addEventListener("pointerup", finish);
    element.addEventListener("pointercancel", finish);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const step = event.shiftKey ? 1 : kKeyPixels;
    const by = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
    if (by) {
      event.preventDefault();
      event.stopPropagation();
      pause();
      move(at.x + by[0]!, at.y + by[1]!);
    } else if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      event.stopPropagation();
      onChoose();
    }
  };
  return (
    <g
      class={`handle${isChosen ? " chosen" : ""}${held.value === testid ? " held" : ""}`}
      data-handle={testid}
      data-testid={testid}
      transform={`translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`}
      tabindex={0}
      role="button"
      aria-label={label}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    >
      <title>{label}</title>
      <circle class="grip" r="16" />
      {kind === "aim" ? (
        <path class="aim" d="M-6 0H6M0 -6V6" />
      ) : (
        <>
          <circle class="bulb" r="7" style={{ fill: color }} />
          {kind === "directional" ? <path class="rays" d="M0-10v-4M0 10v4M10 0h4M-10 0h-4M7-7l3-3M-7 7l-3 3M7 7l3 3M-7-7l-3-3" /> : null}
        </>
      )}
    </g>
  );
}

const pause = pausingDrag();

/** Cone, area, or way of the chosen light. */
function Shape({ light }: { light: LightEntry }) {
  const to = project.value;
  const type = typeOf(light);
  const position = positionOf(light);
  const direction = unit(directionOf(light));
  if (type === "spot") {
    const arm = armOf(light);
    const [x, y] = axesAround(direction);
    const number = (key: string, instead: number) => (typeof light[key] === "number" ? (light[key] as number) : instead);
    const ring = (degrees: number) => {
      const angle = (Math.min(89, degrees) * Math.PI) / 180;
      // A wide cone is cut where it is as wide as long, so that it stays in sight.
      const along = arm * Math.min(1, 1 / Math.tan(angle));
      return circle(add(position, scaled(direction, along)), x, y, along * Math.tan(angle)).map(to);
    };
    const outer = ring(number("cutoff", 45));
    const apex = to(position);
    return (
      <g class="shape">
        <path d={pathOf(outer, true)} />
        {typeof light["beam"] === "number" ? <path class="inner" d={pathOf(ring(number("beam", 0)), true)} /> : null}
        {apex
          ? Array.from({ length: 4 }, (_, i) => outer[(i * kCirclePoints) / 4]).map((point, i) =>
              point ? <path key={i} d={`M${apex.x} ${apex.y}L${point.x} ${point.y}`} /> : null,
            )
          : null}
      </g>
    );
  }
  if (type === "rectangle") {
    const [x, y] = axesAround(direction, light["x_axis"]);
    const [w, h] = Array.isArray(light["size"]) ? (light["size"] as number[]) : [1, 1];
    const corner = (i: number, j: number) => to(add(position, add(scaled(x, (i * w!) / 2), scaled(y, (j * h!) / 2))));
    return (
      <g class="shape">
        <path d={pathOf([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], true)} />
      </g>
    );
  }
  if (type === "disk" || type === "sphere") {
    const radius = typeof light["radius"] === "number" ? light["radius"] : 1;
    const v = view.value;
    const [x, y] = type === "disk" || !v ? axesAround(direction) : [v.right, v.up];
    return (
      <g class="shape">
        <path d={pathOf(circle(position, x, y, radius).map(to), true)} />
      </g>
    );
  }
  return null;
}

function LightHandle({ light, index }: { light: LightEntry; index: number }) {
  const t = words.value.lights;
  const to = project.value;
  const type = typeOf(light);
  const place = to(anchorOf(light));
  const at = place && insidePicture(place);
  const isChosen = selectedLight.value === index;
  const color = screenColor(readColor(light["diffuse"] ?? [1, 1, 1], true)?.linear ?? [1, 1, 1], true);
  const choose = () => {
    selectedLight.value = index;
    panelTab.value = "lights";
  };
  const { center, radius } = reach();
  const onMove = (point: Vec3) => {
    if (hasPosition(type)) {
      update(["lights", index, "position"], rounded(point, Math.max(radius, ...point.map(Math.abs))));
    } else {
      update(["lights", index, "direction"], rounded(unit(subtract(center, point), directionOf(light)), 1));
    }
  };
  const aimPoint = hasPosition(type) ? add(positionOf(light), scaled(unit(directionOf(light)), armOf(light))) : center;
  const aim = hasDirection(type) ? to(aimPoint) : undefined;
  const onAim = (point: Vec3) => {
    const way = subtract(point, positionOf(light));
    if (length(way) > 0) {
      update(["lights", index, "direction"], rounded(unit(way), 1));
    }
  };
  const name = lightLabel(light, index);
  return (
    <g>
      {isChosen ? <Shape light={light} /> : null}
      {isChosen && place && aim ? <path class="arm" d={`M${place.x} ${place.y}L${aim.x} ${aim.y}`} /> : null}
      {isChosen && aim && hasPosition(type) ? (
        <Handle
          at={insidePicture(aim)}
          label={t.aimHandle(name)}
          color={color}
          isChosen
          kind="aim"
          testid={`light-aim-${index}`}
          onMove={onAim}
          onChoose={choose}
        />
      ) : null}
      {at ? (
        <Handle
          at={at}
          label={t.handle(name)}
          color={color}
          isChosen={isChosen}
          kind={type}
          testid={`light-handle-${index}`}
          onMove={onMove}
          onChoose={choose}
        />
      ) : null}
    </g>
  );
}

/** Handles are there while lights are what is worked on; the default rig has none until it is taken over. */
function LightHandles() {
  if (panelTab.value !== "lights" || isDefaultRig.value || pictureRect.value.width === 0) {
    return null;
  }
  return (
    <g class="light-handles">
      {lights.value.map((light, index) => (
        <LightHandle key={index} light={light} index={index} />
      ))}
    </g>
  );
}

register("overlay", { id: "lights", order: 50, component: LightHandles });
