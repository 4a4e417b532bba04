// The lights: the scene's ambient light, the list, and all of the chosen one; its handles are in the view (stage/light-handles.tsx).
import { words } from "../i18n";
import { FalloffPlot } from "../plots/falloff-plot";
import { wordHelpOf, wordLabelOf } from "../i18n/options";
import { Icon } from "../layout/icons";
import { options } from "../state/engine";
import {
  addLight,
  attachLight,
  backToRig,
  directionOf,
  duplicateLight,
  fadingByPower,
  hasDirection,
  hasPosition,
  isArea,
  isDefaultRig,
  lights,
  positionOf,
  removeLight,
  setLightType,
  takeOverRig,
  typeOf,
  type LightEntry,
  type LightType,
} from "../state/lights";
import { view } from "../state/picture";
import { at, attachedLights, updateAll } from "../state/scene";
import { selectedLight } from "../state/selection";
import { dot, length, subtract, unit } from "../stage/vector";
import { readColor, screenColor, writeLinear, writeText, type Rgb } from "./color";
import { niceSize } from "./defaults";
import { FactorRow } from "./factor-row";
import { Group } from "./group";
import { ListHead } from "./list-head";
import { OptionField, transferIsSrgb } from "./option-field";
import { sceneSize } from "./option-rows";
import { Row } from "./row";
import { Segmented } from "./segmented";

function colorOf(light: LightEntry, key = "diffuse"): Rgb {
  return readColor(light[key] ?? [1, 1, 1], transferIsSrgb())?.linear ?? [1, 1, 1];
}

/** The largest channel: what a slider can turn up and down while the hue stays. */
function Brightness({ index, light }: { index: number; light: LightEntry }) {
  const t = words.value.lights;
  const isSrgb = transferIsSrgb();
  const diffuse = colorOf(light);
  const now = Math.max(...diffuse);
  const set = (next: number) => {
    const keys = isArea(typeOf(light)) ? ["diffuse"] : ["diffuse", "specular"];
    updateAll(
      keys.map((key) => {
        const { linear, isText } = readColor(light[key] ?? [1, 1, 1], isSrgb) ?? { linear: [1, 1, 1] as Rgb, isText: false };
        const factor = now > 0 ? next / now : next;
        const scaledColor = (now > 0 ? linear.map((c) => c * factor) : [next, next, next]) as Rgb;
        return [["lights", index, key], isText ? writeText(scaledColor, isSrgb) : writeLinear(scaledColor)] as const;
      }),
    );
  };
  return <FactorRow id="light-brightness" label={t.brightness} help={t.brightnessHelp} value={now} step={0.1} onValue={set} />;
}

/** How the light fades, with what the camera looks at marked on the curves. */
function Fading({ light }: { light: LightEntry }) {
  const type = typeOf(light);
  const reach = niceSize(sceneSize() * 1.5);
  const way = view.value ? subtract(view.value.target, positionOf(light)) : undefined;
  const cosine = way ? dot(unit(way), unit(directionOf(light))) : 1;
  const mark = way ? { distance: length(way), angle: (Math.acos(Math.min(1, Math.max(-1, cosine))) * 180) / Math.PI } : {};
  return <FalloffPlot light={{ ...light, type }} reach={reach} {...mark} />;
}

function Chosen({ index, light }: { index: number; light: LightEntry }) {
  const t = words.value.lights;
  const type = typeOf(light);
  const isSpot = type === "spot";
  const fades = type === "point" || isSpot;
  const field = (key: string) => <OptionField key={key} name={`lights[].${key}`} path={["lights", index, ...key.split(".")]} />;
  const isAttached = attachedLights.value.includes(index);
  const attenuation = ["lights", index, "attenuation"] as const;
  const usesPower = at([...attenuation, "falloff"]).value !== undefined;
  return (
    <Group title={t.chosen(lightLabel(light, index))} testid="light">
      <OptionField
        name="lights[].type"
        path={["lights", index, "type"]}
        onValue={(value) => setLightType(index, value as LightType | undefined)}
      />
      {field("name")}
      <Row id="light-fixed" label={t.fixed} help={t.fixedHelp} isGroup testid="light-fixed">
        <Segmented
          id="light-fixed"
          labelledBy="light-fixed-label"
          segments={[
            { value: "world", label: t.world },
            { value: "camera", label: t.camera },
          ]}
          value={isAttached ? "camera" : "world"}
          onValue={(value) => attachLight(index, value === "camera")}
          testid="light-fixed-input"
        />
      </Row>
      {hasPosition(type) ? field("position") : null}
      {hasDirection(type) ? field("direction") : null}
      <Brightness index={index} light={light} />
      {field("diffuse")}
      {isArea(type) ? null : (
        <>
          {field("specular")}
          {field("ambient")}
        </>
      )}
      {isSpot ? (
        <>
          {field("cutoff")}
          {field("beam")}
          {light["beam"] === undefined ? null : field("fade")}
          {field("exponent")}
        </>
      ) : null}
      {type === "rectangle" ? (
        <>
          {field("size")}
          {field("x_axis")}
        </>
      ) : null}
      {type === "disk" || type === "sphere" ? field("radius") : null}
      {isArea(type) ? <p class="row-help">{t.areaHelp}</p> : field("shadow")}
      {fades ? (
        <>
          <h3 class="sub-title">{t.attenuation}</h3>
          <Fading light={light} />
          {usesPower ? null : (
            <>
              {field("attenuation.constant")}
              {field("attenuation.linear")}
              {field("attenuation.quadratic")}
            </>
          )}
          <OptionField
            name="lights[].attenuation.falloff"
            path={[...attenuation, "falloff"]}
            onValue={(value) => updateAll(fadingByPower(index, value))}
          />
          {field("attenuation.range")}
          {field("attenuation.unclamped")}
        </>
      ) : null}
    </Group>
  );
}

export function lightLabel(light: LightEntry, index: number): string {
  const name = light["name"];
  return typeof name === "string" && name !== "" ? name : `${wordLabelOf("lights[].type", typeOf(light))} ${index + 1}`;
}

function List() {
  const t = words.value.lights;
  const list = lights.value;
  const chosen = selectedLight.value;
  const kinds = options.value.get("lights[].type")?.words ?? [];
  return (
    <section data-testid="lights">
      <ListHead
        words={t}
        choices={kinds.map(({ word, help }) => ({
          value: word as LightType,
          label: wordLabelOf("lights[].type", word),
          help: wordHelpOf("lights[].type", word, help),
        }))}
        canCopy={chosen !== undefined}
        canRemove={chosen !== undefined}
        onAdd={addLight}
        onCopy={() => chosen !== undefined && duplicateLight(chosen)}
        onRemove={() => chosen !== undefined && removeLight(chosen)}
        testid="light"
      />
      {list.length === 0 ? <p class="row-help">{t.none}</p> : null}
      <ul class="object-list" aria-label={t.title}>
        {list.map((light, index) => (
          <li key={index}>
            <button
              class="object"
              type="button"
              aria-pressed={index === chosen}
              data-testid={`light-${index}`}
              onClick={() => (selectedLight.value = index === chosen ? undefined : index)}
            >
              <span class="light-dot" style={{ background: screenColor(colorOf(light), transferIsSrgb()) }} />
              <span class="grow">{lightLabel(light, index)}</span>
              <span class="muted">{wordLabelOf("lights[].type", typeOf(light))}</span>
              {isDefaultRig.value || attachedLights.value.includes(index) ? <Icon name="camera" /> : null}
            </button>
          </li>
        ))}
      </ul>
      {isDefaultRig.value ? (
        <div class="rig">
          <p>{t.rig}</p>
          <button class="action main" type="button" data-testid="rig-take" onClick={takeOverRig}>
            {t.takeOver}
          </button>
        </div>
      ) : (
        <button class="link" type="button" data-testid="rig-back" onClick={backToRig}>
          {t.backToRig}
        </button>
      )}
    </section>
  );
}

export function LightPanel() {
  const chosen = selectedLight.value;
  const light = chosen === undefined || isDefaultRig.value ? undefined : lights.value[chosen];
  return (
    <>
      <List />
      {chosen !== undefined && light ? <Chosen key={chosen} index={chosen} light={light} /> : null}
      <Group title={words.value.lights.around}>
        <OptionField name="ambient" />
      </Group>
    </>
  );
}
