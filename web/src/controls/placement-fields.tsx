// Where the chosen object stands and how large it is: two lines for what most people want of its matrix.
import { words } from "../i18n";
import { matrixOf, placeOf, sizeOf, withPlace, withSize } from "../state/placement";
import { at, update } from "../state/scene";
import { niceSize } from "./defaults";
import { FactorRow } from "./factor-row";
import { sceneSize } from "./option-rows";
import { Row } from "./row";
import { VectorField } from "./vector-field";

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
      <FactorRow id="object-size" label={t.size} help={t.sizeHelp} value={size} step={0.05} onValue={setSize} />
    </>
  );
}
