// The surroundings that a surface mirrors: one picture of all directions, or the six of a cube.
import { words } from "../i18n";
import { helpOf, labelOf } from "../i18n/options";
import { options } from "../state/engine";
import { isTable } from "../state/path";
import { OptionField } from "./option-field";
import { Row } from "./row";
import { Select } from "./select";
import { textureFile, withFile } from "./texture-file";

const kName = "materials.*.textures.reflection";
const kSides = ["right", "left", "top", "bottom", "front", "back"] as const;

type Table = Record<string, unknown>;

/** All pictures that a reflection names. */
export function picturesOf(reflection: unknown): string[] {
  const textures = isTable(reflection) ? [reflection["picture"], ...kSides.map((side) => reflection[side])] : [reflection];
  return textures.map(textureFile).filter((file) => file !== "");
}

export interface ReflectionFieldsProps {
  /** as the scene states it: a picture's path, or a table */
  reflection: unknown;
  pictures: readonly string[];
  onReflection: (reflection: unknown) => void;
}

export function ReflectionFields({ reflection, pictures, onReflection }: ReflectionFieldsProps) {
  const table: Table = isTable(reflection) ? reflection : {};
  const isCube = table["shape"] === "cube";
  const first = isCube ? table["right"] : isTable(reflection) ? table["picture"] : reflection;
  const choice = (key: string, texture: unknown, set: (path: string) => void, none?: string) => {
    const name = key === "" ? kName : `${kName}.${key}`;
    const option = options.value.get(name);
    const id = key === "" ? "texture-reflection" : `texture-reflection-${key}`;
    return option ? (
      <Row key={key} id={id} label={labelOf(name)} help={helpOf(name, option)} testid={id}>
        <Select
          id={id}
          options={[...(none === undefined ? [] : [{ value: "", label: none }]), ...pictures.map((path) => ({ value: path, label: path }))]}
          value={textureFile(texture)}
          onValue={set}
          testid={`${id}-input`}
        />
      </Row>
    ) : null;
  };
  const cubeOf = (pictureOf: (side: string) => unknown) => ({
    shape: "cube",
    ...Object.fromEntries(kSides.map((side) => [side, pictureOf(side)])),
  });
  const sphereOf = (texture: unknown) => (isTable(texture) ? { picture: texture } : texture);
  return (
    <>
      {choice(
        "",
        first,
        (path) => onReflection(path === "" ? undefined : isCube ? cubeOf(() => path) : sphereOf(withFile(first, path))),
        words.value.scenePanel.none,
      )}
      {first === undefined ? null : (
        <OptionField
          name={`${kName}.shape`}
          path={["textures", "reflection", "shape"]}
          value={isCube ? "cube" : undefined}
          onValue={(shape) => onReflection(shape === "cube" ? cubeOf((side) => table[side] ?? first) : sphereOf(first))}
        />
      )}
      {isCube
        ? kSides.map((side) => choice(side, table[side], (path) => onReflection({ ...table, [side]: withFile(table[side], path) })))
        : null}
    </>
  );
}
