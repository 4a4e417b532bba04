// Where the chosen object stands and how large it is: two lines for what most people want of its matrix.
import { words } from "../i18n";
import { matrixOf, placeOf, sizeOf, withPlace, withSize } from "../state/placement";
import { at, update } from "../state/scene";
import { niceSize } from "./defaults";
import { NumberInput } from "./number-input";
import { sceneSize } from "./option-rows";
import { Row } from "./row";
import { Slider } from "./slider";
import { VectorField } from "./vector-field";

const isPositive = (n: number) => Number.isFinite(n) && n > 0;

export function PlacementFields({ index }: { index: number }) {
  const t = words.value.objects;
  const path = ["objects", index, "matrix"] as const;
  const matrix = matrixOf(at(path).value);
  const size = sizeOf(matrix);
  const setSize = (next: number) => update(path, withSize(matrix, next));
  return (
    <>
      <Row id="object-position" label={t.position} help={t.positionHelp} isGroup testid="object-position">
        <VectorField
          label={t.position}
          axes={["x", "y", "z"]}
          value={placeOf(matrix)}
          step={niceSize(sceneSize()) / 100}
          isAllowed={Number.isFinite}
          onValue={(place) => update(path, withPlace(matrix, place))}
          testid="object-position-input"
        />
      </Row>
      <Row id="object-size" label={t.size} help={t.sizeHelp} testid="object-size">
        <div class="number-field">
          <Slider
            label={t.size}
            value={size}
            range={{ from: 0.01, to: 100, scale: "log" }}
            isAllowed={isPositive}
            onValue={setSize}
            testid="object-size-slider"
          />
          <NumberInput
            id="object-size"
            value={Number(size.toPrecision(4))}
            step={0.05}
            isAllowed={isPositive}
            range="> 0"
            onValue={setSize}
            testid="object-size-input"
          />
        </div>
      </Row>
    </>
  );
}
