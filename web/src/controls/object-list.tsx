// The objects of the scene: one is chosen, some can be added, copied and removed; a primitive from coarse to fine.
import { useState } from "preact/hooks";
import { words } from "../i18n";
import { Icon } from "../layout/icons";
import { meshes } from "../state/meshes";
import { addObject, duplicateObject, kPrimitives, objectLabel, primitiveMesh, primitiveOf, removeObject } from "../state/objects";
import { scene, update } from "../state/scene";
import { selectedObject, selectedObjectEntry, selectObject } from "../state/selection";
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
  const [isAdding, setAdding] = useState(false);
  const { objects } = scene.value;
  const chosen = selectedObject.value;
  const entry = selectedObjectEntry.value;
  return (
    <section data-testid="objects">
      <div class="section-head">
        <h2 class="group-title">{t.title}</h2>
        <div class="header-tools">
          <button
            class="tool small"
            type="button"
            aria-expanded={isAdding}
            title={t.add}
            aria-label={t.add}
            data-testid="object-add"
            onClick={() => setAdding(!isAdding)}
          >
            <Icon name="add" />
          </button>
          <button
            class="tool small"
            type="button"
            title={t.copy}
            aria-label={t.copy}
            disabled={!entry}
            data-testid="object-copy"
            onClick={() => duplicateObject(chosen)}
          >
            <Icon name="copy" />
          </button>
          <button
            class="tool small"
            type="button"
            title={t.remove}
            aria-label={t.remove}
            disabled={objects.length < 2}
            data-testid="object-remove"
            onClick={() => removeObject(chosen)}
          >
            <Icon name="remove" />
          </button>
        </div>
      </div>
      {isAdding ? (
        <div class="choices" data-testid="object-add-choices">
          {kPrimitives.map((name) => (
            <button
              key={name}
              class="term plain"
              type="button"
              data-testid={`object-add-${name}`}
              onClick={() => {
                addObject(`primitive:${name}`);
                setAdding(false);
              }}
            >
              {t.shapes[name]}
            </button>
          ))}
        </div>
      ) : null}
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
