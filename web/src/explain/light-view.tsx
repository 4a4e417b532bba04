// One light in one evaluation: its vectors, the cosines, what it loses on its way, and the three products that it adds.
import type { Explanation, FragmentExplanation, LightExplanation, LightInfo, ShadingExplanation, Vec3 } from "../engine/types";
import { hasCone, hasFalloff } from "../plots/falloff";
import { FalloffPlot } from "../plots/falloff-plot";
import { numberTex, numberText } from "../plots/number";
import { hasHighlight, highlightOf, isZero, lightProducts, luminance, microfacetsOf, type Presence, type Product } from "./equation";
import { attenuationTex, kNDotL, microfacetsTex, productTex, specTex } from "./formulas";
import { Letter, Triple, Triples, named } from "./rows";
import { channel } from "./state";
import { Tex } from "./tex";
import { explainWords } from "./words";

const degrees = (cosine: number) => (Math.acos(Math.min(Math.max(cosine, -1), 1)) * 180) / Math.PI;

function cosineTex(letters: string, value: number): string {
  return `${letters} = \\cos ${numberTex(degrees(value), 3)}^\\circ = ${numberTex(value)}`;
}

export interface LightViewProps {
  e: Explanation;
  f: FragmentExplanation;
  s: ShadingExplanation;
  l: LightExplanation;
  has: Presence;
  /** as it shines; undefined while it is not known */
  info: LightInfo | undefined;
  open: boolean;
}

export function ProductLine({ name, kind, value }: { name: string; kind: string; value: Product }) {
  return (
    <div class="x-product">
      <span class="x-product-name">
        <span class={`x-key x-term-${kind}`} />
        {name}
      </span>
      <Tex tex={productTex(value, channel.value)} />
    </div>
  );
}

function why(l: LightExplanation): string | undefined {
  const t = explainWords.value;
  if (l.n_dot_l <= 0) {
    return t.behind;
  }
  if (l.spot === 0) {
    return t.outsideCone;
  }
  return l.visibility === 0 ? t.inShadow : undefined;
}

/** The angle between the axis of a spot and the way to the point. */
function angleFrom(info: LightInfo, l: LightExplanation): number {
  const [x, y, z] = info.direction;
  const size = Math.hypot(x, y, z);
  return size > 0 ? degrees(-(x * l.to_light[0] + y * l.to_light[1] + z * l.to_light[2]) / size) : 0;
}

function LightBody({ e, f, s, l, has, info }: Omit<LightViewProps, "open">) {
  const t = explainWords.value;
  const parts = lightProducts(e, f, s, l, has);
  const highlight = hasHighlight(f);
  const isPhong = f.lighting === "phong";
  const reason = why(l);
  const stated: Record<string, unknown> = info ? { type: info.type, ...info.stated } : {};
  return (
    <div class="x-body">
      {reason === undefined ? null : <p class="x-note">{reason}</p>}
      <Triples label={t.vectors} axes="xyz">
        <Triple name={<Letter name="L" />} value={l.to_light} />
        {highlight && isPhong ? <Triple name={<Letter name="R" />} value={l.reflected} /> : null}
        {highlight && !isPhong ? <Triple name={<Letter name="H" />} value={l.half} /> : null}
      </Triples>
      <ul class="x-formulas">
        <li>
          <Tex tex={cosineTex(kNDotL, l.n_dot_l)} />
        </li>
        {highlight ? (
          <li>
            <Tex tex={isPhong ? cosineTex("R{\\cdot}V", l.r_dot_v) : cosineTex("N{\\cdot}H", l.n_dot_h)} />
          </li>
        ) : null}
        {highlight && f.lighting !== "ggx" ? (
          <li>
            <Tex tex={specTex(f.lighting, highlightOf(e, f, s, l), l.n_dot_l)} />
          </li>
        ) : null}
        {f.lighting === "ggx" && l.n_dot_l > 0
          ? microfacetsTex(microfacetsOf(s, l), s.k_specular[channel.value], l, channel.value).map((tex) => (
              <li key={tex}>
                <Tex tex={tex} />
              </li>
            ))
          : null}
        {l.distance > 0 ? (
          <li title={`${t.attenuation}, ${t.distance} ${numberText(l.distance)}`}>
            <Tex tex={info ? attenuationTex(stated, l) : `f = ${numberTex(l.attenuation)}`} />
          </li>
        ) : null}
        {l.spot !== 1 || info?.type === "spot" ? (
          <li title={t.spot}>
            <Tex tex={`s = ${info ? `s(${numberTex(angleFrom(info, l), 3)}^\\circ) = ` : ""}${numberTex(l.spot)}`} />
          </li>
        ) : null}
        {has.shadows ? (
          <li title={t.visibility}>
            <Tex tex={`v = ${numberTex(l.visibility)}`} />
          </li>
        ) : null}
      </ul>
      {info && hasFalloff(stated) ? (
        <FalloffPlot light={stated} distance={l.distance} {...(hasCone(stated) ? { angle: angleFrom(info, l) } : {})} />
      ) : null}
      <div class="x-products">
        {isZero(l.light_ambient) ? null : <ProductLine name={t.terms.ambient} kind="ambient" value={parts.ambient} />}
        <ProductLine name={t.terms.diffuse} kind="diffuse" value={parts.diffuse} />
        {parts.specular ? <ProductLine name={t.terms.specular} kind="specular" value={parts.specular} /> : null}
      </div>
      <Triples label={t.light(named(l.light, l.name))}>
        {isZero(l.light_ambient) ? null : <Triple name={t.terms.ambient} value={l.ambient} />}
        <Triple name={t.terms.diffuse} value={l.diffuse} />
        {parts.specular ? <Triple name={t.terms.specular} value={l.specular} /> : null}
      </Triples>
    </div>
  );
}

export function LightView({ open, ...props }: LightViewProps) {
  const t = explainWords.value;
  const { l } = props;
  const brings: Vec3 = [0, 1, 2].map((i) => l.ambient[i]! + l.diffuse[i]! + l.specular[i]!) as Vec3;
  return (
    <details class="x-light" open={open} data-testid="explain-light">
      <summary>
        <span>{t.light(named(l.light, l.name))}</span>
        <span class="x-brings" title={t.luminance}>
          {numberText(luminance(brings), 3)}
        </span>
      </summary>
      <LightBody {...props} />
    </details>
  );
}
