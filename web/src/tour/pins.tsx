// The places that a step speaks of, as pins over the picture.
import { project } from "../stage/projection";
import { marks } from "./player";

export function Pins() {
  return (
    <g class="tour-pins">
      {marks.value.map(({ letter, at }) => {
        const point = project.value(at);
        return point ? (
          <g key={letter} transform={`translate(${point.x} ${point.y})`} data-testid={`tour-pin-${letter}`}>
            <circle class="tour-dot" r="3" />
            <path d="M0 -4 V -16" />
            <circle r="10" cy="-26" />
            <text y="-22">{letter}</text>
          </g>
        ) : null;
      })}
    </g>
  );
}
