// What a texture says beside its picture: how it lies on the surface, how it is read, what its values become.
import { isTable, withValue } from "../state/path";
import { OptionField } from "./option-field";

const kPlacing = ["scale", "offset", "rotation"] as const;
const kReading = ["uv_set", "v_down", "wrap", "border", "once", "magnify", "minify", "mip", "lod_bias", "anisotropy"] as const;
const kValues = ["gain", "base", "channel"] as const;
const kUnchanged = [1, 0, 0, 0, 1, 0];

export interface TextureDetailsProps {
  map: string;
  /** as the scene states it: a file's path, or a table */
  texture: unknown;
  onTexture: (texture: unknown) => void;
}

export function TextureDetails({ map, texture, onTexture }: TextureDetailsProps) {
  const table = isTable(texture) ? texture : { file: texture };
  const field = (key: string, more: { implied?: unknown; change?: (value: unknown) => unknown } = {}) => (
    <OptionField
      key={key}
      name={`materials.*.textures.*.${key}`}
      path={["textures", map, key]}
      value={table[key as keyof typeof table]}
      onValue={(value) => onTexture(more.change ? more.change(value) : withValue(table, [key], value))}
      {...(more.implied === undefined ? {} : { implied: more.implied })}
    />
  );
  // A matrix stands in place of the three others: a scene that states both is refused.
  const withMatrix = (value: unknown) =>
    value === undefined
      ? withValue(table, ["matrix"], undefined)
      : kPlacing.reduce((others, key) => withValue(others, [key], undefined), { ...table, matrix: value });
  const hasMatrix = "matrix" in table;
  return (
    <>
      {hasMatrix ? null : kPlacing.map((key) => field(key))}
      {field("matrix", { implied: kUnchanged, change: withMatrix })}
      {kReading.map((key) => field(key))}
      {kValues.map((key) => field(key))}
    </>
  );
}
