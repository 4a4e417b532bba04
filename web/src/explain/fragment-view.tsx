// One surface of the pixel: what it is, the equation of its model, and each evaluation of it: the pixel's point, the face's centre, or the three
// vertices that are interpolated.
import type { Explanation, FragmentExplanation, ShadingExplanation } from "../engine/types";
import { numberTex, numberText, percentText, vectorText } from "../plots/number";
import { lightsShown } from "../state/picture";
import {
  heaviestShading,
  isOne,
  isZero,
  kLitTerms,
  mapsOf,
  presenceIn,
  sceneAmbient,
  sceneEnvironment,
  shadingParts,
  strongestLight,
  type Channel,
  type LitTerm,
} from "./equation";
import { equationTex, highlightTex } from "./formulas";
import { LightView, ProductLine } from "./light-view";
import { Fact, Facts, Letter, Triple, Triples, named } from "./rows";
import { channel } from "./state";
import { Tex } from "./tex";
import { explainWords } from "./words";

/** A material that shows nothing but the shadows on it (MTL's illum). */
const kCatchesShadows = 10;

function Place({ e, f }: { e: Explanation; f: FragmentExplanation }) {
  const t = explainWords.value;
  return (
    <Facts>
      <Fact name={t.object}>{named(f.object, f.object_name)}</Fact>
      <Fact name={t.material}>
        {f.material_name === "" ? "—" : f.material_name} · {f.lighting}
      </Fact>
      <Fact name={t.triangle}>
        {f.triangle}, {f.front ? t.front : t.back}
      </Fact>
      <Fact name={t.barycentrics}>{vectorText(f.barycentrics)}</Fact>
      <Fact name={t.position}>{vectorText(f.position)}</Fact>
      <Fact name={t.depth}>{numberText(f.depth)}</Fact>
      <Fact name={t.samples}>
        {f.samples} / {e.samples}
      </Fact>
      {f.opacity < 1 ? <Fact name={t.opacity}>{numberText(f.opacity)}</Fact> : null}
    </Facts>
  );
}

function Maps({ f }: { f: FragmentExplanation }) {
  const t = explainWords.value;
  return (
    <>
      <h4>{t.maps}</h4>
      <ul class="x-maps">
        {f.maps.map((map) => (
          <li key={map.map}>
            <b>{map.map}</b> {map.name} · ({numberText(map.u)}, {numberText(map.v)}) · {t.mapLevel}{" "}
            {numberText(Math.max(map.level_of_detail, 0), 3)}
            <br />
            {map.applies ? <span class="number">{vectorText(map.value)}</span> : t.mapOutside}
          </li>
        ))}
      </ul>
    </>
  );
}

/** A term of an evaluation as the sum of its parts, with Gouraud's clamp. */
function partsTex(s: ShadingExplanation, term: LitTerm, c: Channel): string {
  const parts = shadingParts(s, term)
    .map((part) => part[c])
    .filter((value) => value !== 0);
  const total = parts.length === 0 ? "0" : parts.map((value) => numberTex(value)).join(" + ");
  const clamp = isOne(s.clamp) ? "" : ` \\cdot ${numberTex(s.clamp[c])}`;
  const shown = clamp !== "" && parts.length > 1 ? `(${total})${clamp}` : `${total}${clamp}`;
  return parts.length > 1 || clamp !== "" ? `${shown} = ${numberTex(s[term][c])}` : shown;
}

function Evaluation({
  e,
  f,
  s,
  title,
  open,
}: {
  e: Explanation;
  f: FragmentExplanation;
  s: ShadingExplanation;
  title: string;
  open: boolean;
}) {
  const t = explainWords.value;
  const has = presenceIn(e);
  const strongest = strongestLight(s);
  const c = channel.value;
  const body =
    f.lighting === "constant" ? (
      <p class="x-note">{f.coefficients["illumination"] === kCatchesShadows ? t.catchesShadows : t.constant}</p>
    ) : (
      <>
        <Triples label={title} axes="xyz">
          <Triple name={<Letter name="N" />} value={s.normal} />
          <Triple name={<Letter name="V" />} value={s.to_eye} />
        </Triples>
        <Triples label={t.coefficients}>
          <Triple name={<Tex tex="k_a" />} value={s.k_ambient} />
          <Triple name={<Tex tex="k_d" />} value={s.k_diffuse} />
          <Triple name={<Tex tex="k_s" />} value={s.k_specular} />
          <Triple name={<Tex tex="k_e" />} value={s.k_emission} />
        </Triples>
        <p class="x-numbers">
          <Tex tex={`n = ${numberTex(s.shininess)}`} />
        </p>
        <h4>{t.aroundUs}</h4>
        <div class="x-products">
          <ProductLine name={t.terms.ambient} kind="ambient" value={sceneAmbient(e, s, has)} />
          {isZero(s.from_environment) ? null : <ProductLine name={t.terms.diffuse} kind="diffuse" value={sceneEnvironment(s, has)} />}
        </div>
        {s.lights.map((l, i) => (
          <LightView key={l.light} e={e} f={f} s={s} l={l} has={has} info={lightsShown.value[l.light]} open={i === strongest} />
        ))}
        <h4>{t.sumOfLights}</h4>
        {isOne(s.clamp) ? null : (
          <p class="x-note">
            {t.clamped} {vectorText(s.clamp)}
          </p>
        )}
        <div class="x-products x-sums">
          {kLitTerms.map((term) => (
            <div class="x-product" key={term}>
              <span class="x-product-name">
                <span class={`x-key x-term-${term}`} />
                {t.terms[term]}
              </span>
              <Tex tex={partsTex(s, term, c)} />
            </div>
          ))}
        </div>
      </>
    );
  return (
    <details class="x-evaluation" open={open} data-testid="explain-evaluation">
      <summary>{title}</summary>
      <div class="x-body">{body}</div>
    </details>
  );
}

/** From the evaluations to the surface's terms: weights, maps, reflection, fog. */
function interpolatedTex(f: FragmentExplanation, term: LitTerm, c: Channel): string {
  const shaded = f.shadings.map((s) => (f.shadings.length > 1 ? `${numberTex(s.weight)} \\cdot ` : "") + numberTex(s[term][c])).join(" + ");
  const maps = mapsOf(f, term)[c];
  const reflection = term === "specular" ? f.reflection[c] : 0;
  const isSum = f.shadings.length > 1;
  let tex = shaded;
  if (maps !== 1) {
    tex = `${isSum ? `(${tex})` : tex} \\cdot \\underbrace{${numberTex(maps)}}_{\\text{${explainWords.value.mapsAfter}}}`;
  }
  if (reflection !== 0) {
    tex = `${tex} + \\underbrace{${numberTex(reflection)}}_{\\text{${explainWords.value.reflection}}}`;
  }
  if (f.fog_factor !== 1) {
    tex = `${isSum || reflection !== 0 ? `(${tex})` : tex} \\cdot ${numberTex(f.fog_factor)}`;
  }
  return `${tex} = ${numberTex(f[term][c])}`;
}

/** The fog's colour by what it hides of the surface. */
function fogTex(f: FragmentExplanation, c: Channel): string {
  const hides = 1 - f.fog_factor;
  return `${numberTex(hides)} \\cdot ${numberTex(f.fog[c] / hides)} = ${numberTex(f.fog[c])}`;
}

function Interpolated({ f }: { f: FragmentExplanation }) {
  const t = explainWords.value;
  const changes = f.fog_factor !== 1 || !isZero(f.reflection) || kLitTerms.some((term) => !isOne(mapsOf(f, term)));
  if (f.shadings.length === 1 && !changes) {
    return null;
  }
  return (
    <>
      <h4>{f.shadings.length > 1 ? t.interpolated : t.sumOfTerms}</h4>
      {f.fog_factor === 1 ? null : (
        <p class="x-note">
          {t.fogFactor}: {numberText(f.fog_factor)}
        </p>
      )}
      <div class="x-products x-sums">
        {kLitTerms
          .filter((term) => !isZero(f[term]) || f.shadings.some((s) => !isZero(s[term])))
          .map((term) => (
            <div class="x-product" key={term}>
              <span class="x-product-name">
                <span class={`x-key x-term-${term}`} />
                {t.terms[term]}
              </span>
              <Tex tex={interpolatedTex(f, term, channel.value)} />
            </div>
          ))}
        {f.fog_factor === 1 ? null : (
          <div class="x-product">
            <span class="x-product-name">
              <span class="x-key x-term-fog" />
              {t.terms.fog}
            </span>
            <Tex tex={fogTex(f, channel.value)} />
          </div>
        )}
      </div>
    </>
  );
}

function evaluationTitle(e: Explanation, s: ShadingExplanation, index: number): string {
  const t = explainWords.value;
  switch (e.interpolation) {
    case "gouraud":
      return `${t.vertex(index + 1)} · ${t.weight} ${numberText(s.weight)}`;
    case "flat":
      return t.face;
    case "phong":
      return t.pixelPoint;
  }
}

export function FragmentView({ e, f, index, open }: { e: Explanation; f: FragmentExplanation; index: number; open: boolean }) {
  const t = explainWords.value;
  const has = { ...presenceIn(e), environment: f.shadings.some((s) => !isZero(s.from_environment)) };
  const highlight = highlightTex(f.lighting, e.normalized);
  const heaviest = heaviestShading(f);
  return (
    <details class="x-section" open={open} data-testid="explain-fragment">
      <summary>
        {t.surface(index + 1, e.fragments.length)}{" "}
        <span class="x-muted">
          {named(f.object, f.object_name)} · {percentText(f.weight)} {t.ofThePixel}
        </span>
      </summary>
      <div class="x-body">
        <Place e={e} f={f} />
        {f.maps.length > 0 ? <Maps f={f} /> : null}
        <h4>{t.equation}</h4>
        <Tex block tex={equationTex(f.lighting, has)} />
        {highlight === "" ? null : <Tex block tex={highlight} />}
        <h4>{t.withNumbers}</h4>
        {f.shadings.map((s, i) => (
          <Evaluation key={i} e={e} f={f} s={s} title={evaluationTitle(e, s, i)} open={i === heaviest} />
        ))}
        <Interpolated f={f} />
      </div>
    </details>
  );
}
