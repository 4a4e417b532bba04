// From where the scene is seen: projection, views, and the numbers; what the camera has chosen by itself stands in gray.
import { words } from "../i18n";
import { wordHelpOf, wordLabelOf } from "../i18n/options";
import { frameAll, setProjection, showPreset } from "../stage/camera";
import { options } from "../state/engine";
import { view } from "../state/picture";
import { at, update } from "../state/scene";
import { Group } from "./group";
import { OptionField } from "./option-field";

const kKeys: Record<string, string> = { front: "1", back: "⇧1", right: "3", left: "⇧3", top: "7", bottom: "⇧7", "three-quarter": "⇱" };

function Views() {
  const eye = at("camera.eye").value;
  const stated = at<string>("camera.view").value ?? "three-quarter";
  const names = options.value.get("camera.view")?.words ?? [];
  return (
    <div class="views">
      {names.map(({ word, help }) => (
        <button
          key={word}
          class="term plain"
          type="button"
          aria-pressed={eye === undefined && stated === word}
          data-help={wordHelpOf("camera.view", word, help)}
          data-testid={`view-${word}`}
          onClick={() => showPreset(word)}
        >
          {wordLabelOf("camera.view", word)}
          {kKeys[word] ? <kbd>{kKeys[word]}</kbd> : null}
        </button>
      ))}
    </div>
  );
}

export function CameraPanel() {
  const t = words.value.cameraPanel;
  const v = view.value;
  const isOrthographic = (at("camera.projection").value ?? "perspective") === "orthographic";
  return (
    <>
      <OptionField
        name="camera.projection"
        onValue={(value) =>
          value === undefined ? update("camera.projection", undefined) : setProjection(value as "perspective" | "orthographic")
        }
      />
      <Group title={t.views}>
        <Views />
        <button class="action wide" type="button" data-testid="camera-frame" onClick={frameAll}>
          {words.value.stage.frame} <kbd>F</kbd>
        </button>
      </Group>
      <Group title={t.numbers}>
        {isOrthographic ? (
          <OptionField name="camera.height" implied={v && v.height / v.pixelsPerUnit} />
        ) : (
          <OptionField name="camera.fov" />
        )}
        <OptionField name="camera.eye" implied={v?.eye} />
        <OptionField name="camera.target" implied={v?.target} />
        <OptionField name="camera.up" implied={v?.up} />
        <OptionField name="camera.near" implied={v?.near} />
        <OptionField name="camera.far" implied={v?.far} />
      </Group>
      <Group title={t.hands}>
        <dl class="facts">
          {t.gestures.map(([how, what]) => (
            <div key={how}>
              <dt>{how}</dt>
              <dd>{what}</dd>
            </div>
          ))}
        </dl>
      </Group>
    </>
  );
}
