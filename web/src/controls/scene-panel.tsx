// The picture's size and storing, what surrounds the objects, and facts of what is shown.
import { words } from "../i18n";
import { engineInfo } from "../state/engine";
import { meshes } from "../state/meshes";
import { readable } from "../state/messages";
import { fullSize, picture } from "../state/picture";
import { at, scene, updateAll } from "../state/scene";
import { readColor, writeLinear, type Rgb } from "./color";
import { Group } from "./group";
import { OptionField, transferIsSrgb } from "./option-field";
import { sceneSize } from "./option-rows";
import { openedPictures } from "../state/files";
import { Row } from "./row";
import { Segmented } from "./segmented";
import { Select } from "./select";
import { ToggleGroup } from "./toggle-group";

const width = at<number>("image.width");
const height = at<number>("image.height");
const fogMode = at<string>("fog.mode");
const skyPicture = at<string>("environment.file");
const kSkyColor = [0.2, 0.22, 0.26];

function PictureSize() {
  const t = words.value.scenePanel;
  const isStated = width.value !== undefined || height.value !== undefined;
  const take = (value: string) => {
    const full = fullSize.peek();
    updateAll(
      value === "window"
        ? [
            ["image.width", undefined],
            ["image.height", undefined],
          ]
        : [
            ["image.width", full.width],
            ["image.height", full.height],
          ],
      "",
    );
  };
  return (
    <>
      <Row id="picture-size" label={t.size} help={t.sizeHelp} isGroup testid="picture-size">
        <Segmented
          id="picture-size"
          labelledBy="picture-size-label"
          segments={[
            { value: "window", label: t.window },
            { value: "stated", label: t.stated },
          ]}
          value={isStated ? "stated" : "window"}
          onValue={take}
          testid="picture-size-input"
        />
      </Row>
      {isStated ? (
        <>
          <OptionField name="image.width" />
          <OptionField name="image.height" />
        </>
      ) : null}
    </>
  );
}

function EnvironmentFile() {
  const t = words.value.scenePanel;
  const pictures = openedPictures();
  const chosen = skyPicture.value ?? "";
  if (pictures.length === 0 && chosen === "") {
    return null;
  }
  const all = chosen !== "" && !pictures.includes(chosen) ? [chosen, ...pictures] : pictures;
  return (
    <Row id="environment-file" label={t.environmentFile} help={t.environmentFileHelp} testid="environment-file">
      <Select
        id="environment-file"
        options={[{ value: "", label: t.none }, ...all.map((path) => ({ value: path, label: path }))]}
        value={chosen}
        // A sky has a picture or a colour: a scene that states both is refused.
        onValue={(path) =>
          updateAll([
            ["environment.file", path === "" ? undefined : path],
            ["environment.color", path === "" ? kSkyColor : undefined],
          ])
        }
        testid="environment-file-input"
      />
    </Row>
  );
}

function Facts() {
  const t = words.value.scenePanel;
  const drawn = picture.value;
  const info = engineInfo.value;
  const count = (of: "vertices" | "triangles") => meshes.value.reduce((sum, mesh) => sum + mesh[of], 0).toLocaleString();
  const rows: [string, string][] = [
    [t.objects, String(scene.value.objects.length)],
    [t.triangles, count("triangles")],
    [t.vertices, count("vertices")],
    [t.pixels, drawn ? `${drawn.width} × ${drawn.height}` : ""],
    [t.time, drawn ? `${drawn.milliseconds.toFixed(drawn.milliseconds < 20 ? 1 : 0)} ms` : ""],
    [t.engine, info ? `Lustro ${info.version}, ${info.target}, ${t.workers(info.threads)}` : ""],
  ];
  return (
    <Group title={t.facts} testid="facts">
      <dl class="facts">
        {rows.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd class="number">{value}</dd>
          </div>
        ))}
      </dl>
      {info?.singleThreadedBecause ? <p class="row-help">{t.oneWorker(info.singleThreadedBecause)}</p> : null}
      {drawn && drawn.notes.length > 0 ? (
        <ul class="notes" data-testid="notes">
          {drawn.notes.map((note) => (
            <li key={note}>{readable(note)}</li>
          ))}
        </ul>
      ) : null}
    </Group>
  );
}

/** What is seen behind everything, without its alpha: what far things fade to. */
function background(): Rgb {
  return readColor(scene.peek().image?.["background"] ?? [0.1, 0.1, 0.12], transferIsSrgb())?.linear ?? [0, 0, 0];
}

export function ScenePanel() {
  const t = words.value.scenePanel;
  const isLinear = fogMode.value === "linear";
  const size = sceneSize();
  return (
    <>
      <Group title={t.picture}>
        <PictureSize />
        <OptionField name="image.background" />
        <OptionField name="image.transparent" />
        <OptionField name="image.transfer" />
        <OptionField name="image.tone.operator" />
        <OptionField name="image.tone.exposure" />
      </Group>
      <ToggleGroup name="shadow" onValue={() => true}>
        <OptionField name="shadow.size" />
        <OptionField name="shadow.softness" />
      </ToggleGroup>
      <ToggleGroup name="occlusion" onValue={() => true}>
        <OptionField name="occlusion.directions" />
        <OptionField name="occlusion.size" />
        <OptionField name="occlusion.radius" implied={size / 4} />
      </ToggleGroup>
      <ToggleGroup name="ground" onValue={() => true}>
        <OptionField name="ground.height" implied={picture.value?.view.lower[1]} />
        <OptionField name="ground.strength" />
      </ToggleGroup>
      <ToggleGroup
        name="fog"
        onValue={() => ({
          mode: "exp2",
          density: Number((0.5 / size).toPrecision(2)),
          color: writeLinear(background()),
        })}
      >
        <OptionField name="fog.mode" />
        {isLinear ? (
          <>
            <OptionField name="fog.start" />
            <OptionField name="fog.end" />
          </>
        ) : (
          <OptionField name="fog.density" />
        )}
        <OptionField name="fog.color" />
      </ToggleGroup>
      <ToggleGroup name="environment" onValue={() => ({ color: kSkyColor })}>
        <EnvironmentFile />
        {skyPicture.value === undefined ? <OptionField name="environment.color" /> : null}
        <OptionField name="environment.gain" />
        <OptionField name="environment.rotation" />
        <OptionField name="environment.visible" />
      </ToggleGroup>
      <Facts />
    </>
  );
}
