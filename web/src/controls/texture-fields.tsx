// Which of the opened pictures drives which coefficient.
import { words } from "../i18n";
import { labelOf, helpOf } from "../i18n/options";
import { options } from "../state/engine";
import { setCoefficient, type MaterialSource } from "../state/objects";
import { isTable, withValue } from "../state/path";
import { Group } from "./group";
import { OptionField } from "./option-field";
import { openedPictures } from "../state/files";
import { Row } from "./row";
import { picturesOf, ReflectionFields } from "./reflection-fields";
import { Select } from "./select";
import { TextureDetails } from "./texture-details";
import { textureFile, withFile } from "./texture-file";

const kMaps = ["ambient", "diffuse", "specular", "emission", "shininess", "opacity", "decal", "bump", "normal", "displacement"] as const;
export function TextureFields({ index, source }: { index: number; source: MaterialSource }) {
  const t = words.value.material;
  const textures = isTable(source.table["textures"]) ? source.table["textures"] : {};
  const stated = kMaps.filter((map) => textureFile(textures[map]) !== "");
  const reflected = picturesOf(textures["reflection"]);
  const pictures = [...new Set([...openedPictures(), ...stated.map((map) => textureFile(textures[map])), ...reflected])];
  const set = (map: string, value: unknown) => {
    const next = withValue(textures, [map], value);
    setCoefficient(index, "textures", Object.keys(next).length === 0 ? undefined : next);
  };
  return (
    <Group title={t.textures} isFoldable isOpen={stated.length + reflected.length > 0} testid="textures">
      {pictures.length === 0 ? <p class="row-help">{t.noPictures}</p> : null}
      {pictures.length === 0
        ? null
        : kMaps.map((map) => {
            const option = options.value.get(`materials.*.textures.${map}`);
            const file = textureFile(textures[map]);
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
                    onValue={(path) => set(map, path === "" ? undefined : withFile(textures[map], path))}
                    testid={`texture-${map}-input`}
                  />
                </Row>
                {file === "" ? null : (
                  <details class="details">
                    <summary>{words.value.controls.more}</summary>
                    <TextureDetails map={map} texture={textures[map]} onTexture={(texture) => set(map, texture)} />
                  </details>
                )}
                {map === "normal" && file !== "" ? (
                  <OptionField
                    name="materials.*.textures.object_space"
                    path={["textures", "object_space"]}
                    value={textures["object_space"]}
                    onValue={(value) => set("object_space", value)}
                  />
                ) : null}
              </div>
            );
          })}
      {pictures.length === 0 ? null : (
        <ReflectionFields
          reflection={textures["reflection"]}
          pictures={pictures}
          onReflection={(reflection) => set("reflection", reflection)}
        />
      )}
    </Group>
  );
}
