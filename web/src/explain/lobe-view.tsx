// The highlight's lobe of the chosen light, classic or normalised.
import { signal } from "@preact/signals";
import type { Explanation } from "../engine/types";
import { LobePlot } from "./lobe-plot";
import { inPlane, planeOf } from "./lobe";
import { numberText } from "../plots/number";
import { hasHighlight, isZero } from "./equation";
import { LightChoice } from "./light-choice";
import { Section } from "./rows";
import { subject } from "./state";
import { explainWords } from "./words";

/** undefined: as the scene has it */
const shownNormalized = signal<boolean | undefined>(undefined);

function Lobe({ e }: { e: Explanation }) {
  const t = explainWords.value;
  const { fragment: f, shading: s, light } = subject.value!;
  const l = s.lights[light];
  if (!hasHighlight(f) || !l) {
    return <p class="x-note">{t.lobeNoModel}</p>;
  }
  if (l.n_dot_l <= 0) {
    return <p class="x-note">{t.lobeNone}</p>;
  }
  const normalized = shownNormalized.value ?? e.normalized;
  const surface = { lighting: f.lighting, n: s.shininess, k_s: s.k_specular, normal: s.normal, toLight: l.to_light, normalized };
  const { outside } = inPlane(planeOf(s.normal, l.to_light, s.to_eye), s.to_eye);
  return (
    <>
      <LobePlot surface={surface} toEye={s.to_eye} half={l.half} />
      {isZero(s.k_specular) && f.lighting !== "ggx" ? <p class="x-note">{t.lobeUnused}</p> : null}
      {outside > 1 ? <p class="x-note">{t.eyeOutside(numberText(outside, 2))}</p> : null}
      {f.lighting === "ggx" ? null : (
        <label class="x-check">
          <input
            type="checkbox"
            checked={normalized}
            onChange={(event) => (shownNormalized.value = event.currentTarget.checked)}
            data-testid="lobe-normalized"
          />{" "}
          {t.normalized}
        </label>
      )}
    </>
  );
}

export function LobeView({ e }: { e: Explanation }) {
  const t = explainWords.value;
  return subject.value ? (
    <Section id="lobe" title={t.lobe}>
      <LightChoice testId="lobe-light" />
      <Lobe e={e} />
      <p class="x-note">{t.lobeHelp}</p>
    </Section>
  ) : null;
}
