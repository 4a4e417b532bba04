// The objects of the scene: one is chosen, some can be added, copied and removed; a primitive from coarse to fine.
import { words } from "../i18n";
import { meshes } from "../state/meshes";
import { addObject, duplicateObject, kPrimitives, objectLabel, primitiveMesh, primitiveOf, removeObject } from "../state/objects";
import { scene, update } from "../state/scene";
import { selectedObject, selectedObjectEntry, selectObject } from "../state/selection";
import { ListHead } from "./list-head";
import { NumberInput } from "./number-input";
import { Row } from "./row";
import { Select } from "./select";
import { Slider } from "./slider";

const kSegments = { from: 3, to: 256, scale: "log" } as const;
const isSegments = (n: number) => Number.isInteger(n) && n >= 3 && n <= 1024;

function Tessellation({ index, mesh }: { index: number; mesh: string }) {
  const t = words.value.objects;
  const primitive = primitiveOf(mesh);
  if (!primitive) {
    return null;
  }
  const path = ["objects", index, "mesh"] as const;
  const segments = primitive.segments;
  return (
    <>
      <Row id="object-shape" label={t.shape} help={t.shapeHelp} testid="object-shape">
        <Select
          id="object-shape"
          options={kPrimitives.map((name) => ({ value: name, label: t.shapes[name] }))}
          value={primitive.name}
          onValue={(name) =>
            update(path, primitiveMesh(name, name === "teapot" ? undefined : segments && segments >= 3 ? segments : undefined))
          }
          testid="object-shape-input"
        />
      </Row>
      {primitive.name === "teapot" ? null : (
        <Row id="object-segments" label={t.segments} help={t.segmentsHelp} testid="object-segments">
          <div class="number-field">
            <Slider
              label={t.segments}
              value={segments ?? 3}
              range={kSegments}
              isInteger
              isAllowed={isSegments}
              onValue={(n) => update(path, primitiveMesh(primitive.name, n))}
              testid="object-segments-slider"
            />
            <NumberInput
              id="object-segments"
              value={segments}
              step={1}
              isAllowed={isSegments}
              range="3..1024"
              onValue={(n) => update(path, primitiveMesh(primitive.name, n))}
              testid="object-segments-input"
            />
          </div>
        </Row>
      )}
    </>
  );
}

export function ObjectList() {
  const t = words.value.objects;
  const { objects } = scene.value;
  const chosen = selectedObject.value;
  const entry = selectedObjectEntry.value;
  return (
    <section data-testid="objects">
      <ListHead
        words={t}
        choices={kPrimitives.map((name) => ({ value: name, label: t.shapes[name] }))}
        canCopy={entry !== undefined}
        canRemove={objects.length > 1}
        onAdd={(name) => addObject(`primitive:${name}`)}
        onCopy={() => duplicateObject(chosen)}
        onRemove={() => removeObject(chosen)}
        testid="object"
      />
      <ul class="object-list" aria-label={t.title}>
        {objects.map((object, index) => (
          <li key={index}>
            <button
              class="object"
              type="button"
              aria-pressed={index === chosen}
              data-testid={`object-${index}`}
              onClick={() => selectObject(index)}
            >
              <span>{objectLabel(object, index)}</span>
              <span class="number muted">{meshes.value[index] ? t.triangles(meshes.value[index].triangles) : ""}</span>
            </button>
          </li>
        ))}
      </ul>
      {entry ? <Tessellation index={chosen} mesh={entry.mesh} /> : null}
    </section>
  );
}
