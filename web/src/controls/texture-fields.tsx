// Which of the opened pictures drives which coefficient. What else a texture can say (wrap, scale, filters) is kept as the scene states it.
import { words } from "../i18n";
import { labelOf, helpOf } from "../i18n/options";
import { options } from "../state/engine";
import { setCoefficient, type MaterialSource } from "../state/objects";
import { isTable, withValue } from "../state/path";
import { Group } from "./group";
import { OptionField } from "./option-field";
import { openedPictures } from "../state/files";
import { Row } from "./row";
import { Select } from "./select";

const kMaps = ["ambient", "diffuse", "specular", "emission", "shininess", "opacity", "decal", "bump", "normal", "displacement"] as const;
const kDetails = [
  "scale",
  "offset",
  "rotation",
  "wrap",
  "magnify",
  "minify",
  "mip",
  "anisotropy",
  "gain",
  "base",
  "channel",
  "v_down",
] as const;

function fileOf(texture: unknown): string {
  return typeof texture === "string" ? texture : isTable(texture) && typeof texture["file"] === "string" ? texture["file"] : "";
}

export function TextureFields({ index, source }: { index: number; source: MaterialSource }) {
  const t = words.value.material;
  const textures = isTable(source.table["textures"]) ? source.table["textures"] : {};
  const stated = kMaps.filter((map) => fileOf(textures[map]) !== "");
  const pictures = [...new Set([...openedPictures(), ...stated.map((map) => fileOf(textures[map]))])];
  const set = (map: string, value: unknown) => {
    const next = withValue(textures, [map], value);
    setCoefficient(index, "textures", Object.keys(next).length === 0 ? undefined : next);
  };
  return (
    <Group title={t.textures} isFoldable isOpen={stated.length > 0} testid="textures">
      {pictures.length === 0 ? <p class="row-help">{t.noPictures}</p> : null}
      {pictures.length === 0
        ? null
        : kMaps.map((map) => {
            const option = options.value.get(`materials.*.textures.${map}`);
            const file = fileOf(textures[map]);
            return (
              <div key={map}>
                <Row
                  id={`texture-${map}`}
                  label={labelOf(`materials.*.textures.${map}`)}
                  help={option ? helpOf(`materials.*.textures.${map}`, option) : ""}
                  testid={`texture-${map}`}
                >
                  <Select
                    id={`texture-${map}`}
                    options={[{ value: "", label: words.value.scenePanel.none }, ...pictures.map((path) => ({ value: path, label: path }))]}
                    value={file}
                    onValue={(path) => set(map, path === "" ? undefined : isTable(textures[map]) ? { ...textures[map], file: path } : path)}
                    testid={`texture-${map}-input`}
                  />
                </Row>
                {file === "" ? null : (
                  <details class="details">
                    <summary>{words.value.controls.more}</summary>
                    {kDetails.map((key) => (
                      <OptionField
                        key={key}
                        name={`materials.*.textures.*.${key}`}
                        path={["textures", map, key]}
                        value={isTable(textures[map]) ? textures[map][key] : undefined}
                        onValue={(value) => set(map, withValue(isTable(textures[map]) ? textures[map] : { file }, [key], value))}
                      />
                    ))}
                  </details>
                )}
              </div>
            );
          })}
    </Group>
  );
}
