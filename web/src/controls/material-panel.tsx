// What an object is made of: the library as polished balls, then the coefficients of the equation.
import { words } from "../i18n";
import { libraryMaterials } from "../state/engine";
import { isTable, pathSteps } from "../state/path";
import { materialOf, setCoefficient, setMaterial, type MaterialSource } from "../state/objects";
import { at, scene } from "../state/scene";
import { selectedObject } from "../state/selection";
import { Group } from "./group";
import { ObjectList } from "./object-list";
import { OptionField } from "./option-field";
import { PlacementFields } from "./placement-fields";
import { TextureFields } from "./texture-fields";
import { ThumbnailView } from "./thumbnail";

/** Names with spaces in place of underscores. */
const spoken = (name: string) => name.replaceAll("_", " ");

function Library({ index, source }: { index: number; source: MaterialSource }) {
  const t = words.value.material;
  const chosen = source.kind === "library" ? source.name : undefined;
  return (
    <div class="library" role="group" aria-label={t.library} data-testid="library">
      {libraryMaterials.value.map(({ name }) => (
        <button
          key={name}
          class="ball"
          type="button"
          aria-pressed={name === chosen}
          aria-label={spoken(name)}
          title={spoken(name)}
          data-testid={`material-${name}`}
          onClick={() => setMaterial(index, name)}
        >
          <ThumbnailView name={`material/${name}`} />
          <span>{spoken(name)}</span>
        </button>
      ))}
    </div>
  );
}

function Origin({ index, source }: { index: number; source: MaterialSource }) {
  const t = words.value.material;
  const text =
    source.kind === "library"
      ? t.ofLibrary(spoken(source.name))
      : source.kind === "stated"
        ? source.name === ""
          ? t.ofScene
          : t.ofSceneNamed(source.name)
        : source.names.length === 0
          ? t.ofDefault
          : source.names.length === 1
            ? t.ofMesh(source.names[0]!)
            : t.ofMeshMany(source.names.length);
  return (
    <p class="origin" data-testid="material-origin">
      {text}{" "}
      {source.kind === "own" ? null : (
        <button class="link" type="button" data-testid="material-own" onClick={() => setMaterial(index, undefined)}>
          {t.backToOwn}
        </button>
      )}
    </p>
  );
}

/** What the library or the mesh states; a colour beside its texture is white where nothing is stated. */
function impliedOf(source: MaterialSource, key: string): { implied?: unknown } {
  if (source.kind !== "stated") {
    return { implied: source.table[key] };
  }
  const { textures } = source.table;
  return isTable(textures) && textures[key] !== undefined && kColors.has(key) ? { implied: [1, 1, 1] } : {};
}

const kColors = new Set(["ambient", "diffuse", "specular", "emission"]);
const kCoefficients = ["ambient", "diffuse", "specular", "emission", "shininess", "opacity"] as const;
const kMore = ["alpha_mode", "alpha_cutoff", "lighting", "cull"] as const;
const kOfThePathTracer = ["illumination", "refraction", "transmission"] as const;

export function MaterialPanel() {
  const t = words.value.material;
  const index = selectedObject.value;
  const source = materialOf(scene.value, index);
  const lighting = source.table["lighting"] ?? at("shading.lighting").value ?? "phong";
  const isMatt = lighting === "lambert" || lighting === "constant";
  const field = (key: string, idle?: string) => (
    <OptionField
      key={key}
      name={`materials.*.${key}`}
      path={[...pathSteps(source.path), key]}
      // What the library or the mesh states is shown as what holds; a change states all of it in the scene.
      {...impliedOf(source, key)}
      onValue={(value) => setCoefficient(index, key, value)}
      idle={idle}
    />
  );
  return (
    <>
      <ObjectList />
      <Group title={t.library}>
        <Library index={index} source={source} />
        <Origin index={index} source={source} />
      </Group>
      <Group title={t.coefficients} testid="coefficients">
        {kCoefficients.map((key) =>
          field(key, isMatt && (key === "specular" || key === "shininess") ? words.value.shading.needsHighlight : undefined),
        )}
      </Group>
      <Group title={t.more} isFoldable isOpen={false} testid="material-more">
        {kMore.map((key) => field(key))}
      </Group>
      <TextureFields index={index} source={source} />
      <Group title={t.pathTracer} isFoldable isOpen={false} testid="material-path">
        <p class="row-help">{t.pathTracerHelp}</p>
        {kOfThePathTracer.map((key) => field(key))}
      </Group>
      <Group title={t.place} isFoldable isOpen={false} testid="object-place">
        <OptionField name="objects[].name" path={["objects", index, "name"]} />
        {field("name")}
        <PlacementFields index={index} />
        <OptionField name="objects[].matrix" path={["objects", index, "matrix"]} />
      </Group>
    </>
  );
}
