// The pixel's colour: linear, stored, as a swatch, and the sum of terms that makes it.
import { numberTex, numberText, percentText } from "../plots/number";
import { fullRequest } from "../state/picture";
import type { Explanation, Vec3 } from "../engine/types";
import { chosenChannel, channel } from "./state";
import { isZero, kTerms, luminance, type Channel } from "./equation";
import { Triple, Triples, named } from "./rows";
import { Tex } from "./tex";
import { explainWords } from "./words";

export const hexOf = (bytes: readonly number[]) =>
  `#${bytes
    .slice(0, 3)
    .map((byte) => byte.toString(16).padStart(2, "0"))
    .join("")}`;

/** What stands between the linear colour and the bytes: a curve that the scene states. */
function toneName(): string | undefined {
  const tone = fullRequest.value.scene.image?.["tone"];
  if (typeof tone !== "object" || tone === null) {
    return undefined;
  }
  const { operator = "none", exposure = 0 } = tone as Record<string, unknown>;
  const parts = [operator === "none" ? "" : String(operator), exposure === 0 ? "" : `2^${String(exposure)}`].filter((part) => part !== "");
  return parts.length > 0 ? parts.join(", ") : undefined;
}

function storedHow(): string {
  const transfer = fullRequest.value.scene.image?.["transfer"] ?? "srgb";
  const tone = toneName();
  return `${tone === undefined ? "" : `${explainWords.value.tone} (${tone}), `}${transfer === "none" ? explainWords.value.linear : "sRGB"}`;
}

export function Swatch({ bytes, label }: { bytes: readonly number[]; label: string }) {
  return (
    <span
      class="x-swatch"
      style={{ "--swatch": `rgb(${bytes.slice(0, 3).join(" ")} / ${bytes[3]! / 255})` }}
      role="img"
      aria-label={label}
    />
  );
}

function ChannelChoice() {
  const t = explainWords.value;
  return (
    <fieldset class="x-channels">
      <legend class="visually-hidden">{t.channel}</legend>
      {[t.red, t.green, t.blue].map((name, i) => (
        <label key={i} title={`${t.channel}: ${name}`}>
          <input type="radio" name="explain-channel" checked={channel.value === i} onChange={() => (chosenChannel.value = i as Channel)} />
          <span class={`x-channel-${i}`}>{"RGB"[i]}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** The share of each term, by luminance. */
function TermBar({ e }: { e: Explanation }) {
  const t = explainWords.value;
  const parts = kTerms.map((term) => ({ term, amount: Math.max(luminance(e[term]), 0) })).filter(({ amount }) => amount > 0);
  const whole = parts.reduce((total, { amount }) => total + amount, 0);
  const label = parts.map(({ term, amount }) => `${t.terms[term]} ${numberText((100 * amount) / whole, 3)} %`).join(", ");
  return whole > 0 ? (
    <div class="x-bar" role="img" aria-label={label} title={label}>
      {parts.map(({ term, amount }) => (
        <span key={term} class={`x-term-${term}`} style={{ flexGrow: amount / whole }} />
      ))}
    </div>
  ) : null;
}

function sumTex(e: Explanation, c: Channel): string {
  const t = explainWords.value;
  const parts = kTerms
    .filter((term) => !isZero(e[term]))
    .map((term) => `\\underbrace{${numberTex(e[term][c])}}_{\\text{${t.terms[term]}}}`);
  return `${parts.length === 0 ? "0" : parts.join(" + ")} = ${numberTex(e.color[c])}`;
}

/** What each surface, and the background, brings to the pixel. */
function Shares({ e }: { e: Explanation }) {
  const t = explainWords.value;
  return (
    <Triples label={t.byShare}>
      {e.fragments.map((f, i) => (
        <Triple
          key={i}
          name={`${percentText(f.weight)} ${named(f.object, f.object_name)}`}
          value={[0, 1, 2].map((c) => f.weight * (f.ambient[c]! + f.diffuse[c]! + f.specular[c]! + f.emission[c]! + f.fog[c]!))}
        />
      ))}
      {e.background_weight > 0 ? <Triple name={`${percentText(e.background_weight)} ${t.terms.background}`} value={e.background} /> : null}
    </Triples>
  );
}

export function Result({ e, onCopy }: { e: Explanation; onCopy: () => void }) {
  const t = explainWords.value;
  const code = hexOf(e.bytes);
  return (
    <section class="x-result" aria-label={t.result}>
      <div class="x-result-head">
        <Swatch bytes={e.bytes} label={`${t.color} ${code}`} />
        <div>
          <output class="x-hex" data-testid="explain-hex">
            {code}
          </output>
          <span class="x-muted">
            {" "}
            {e.bytes.slice(0, 3).join(", ")}
            {e.bytes[3] === 255 ? "" : ` · ${t.alpha} ${e.bytes[3]}`} · {storedHow()}
          </span>
        </div>
        <button class="action x-copy" type="button" onClick={onCopy} data-testid="explain-copy">
          {t.copy}
        </button>
      </div>
      <div class="x-line">
        <h3>{t.sumOfTerms}</h3>
        <ChannelChoice />
      </div>
      <TermBar e={e} />
      <Triples label={t.sumOfTerms}>
        {kTerms.map((term, i) => (
          <Triple
            key={term}
            kind="x-term-row"
            name={
              <>
                <span class={`x-key x-term-${term}`} />
                {i === 0 ? "" : "+ "}
                {t.terms[term]}
              </>
            }
            value={e[term]}
          />
        ))}
        <Triple kind="x-sum" name={`= ${t.color}, ${t.linear}`} value={e.color.slice(0, 3) as Vec3} />
        {e.color[3] === 1 ? null : (
          <tr>
            <th scope="row">{t.alpha}</th>
            <td colSpan={3}>{numberText(e.color[3])}</td>
          </tr>
        )}
        <tr>
          <th scope="row">{t.stored}</th>
          {[0, 1, 2].map((i) => (
            <td key={i}>{e.bytes[i]}</td>
          ))}
        </tr>
      </Triples>
      <p class={`x-numbers x-channel-${channel.value}`} data-testid="explain-sum">
        <Tex tex={sumTex(e, channel.value)} />
      </p>
      {e.fragments.length + (e.background_weight > 0 ? 1 : 0) > 1 ? (
        <>
          <h4>{t.byShare}</h4>
          <Shares e={e} />
        </>
      ) : null}
    </section>
  );
}
