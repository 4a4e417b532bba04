// A colour: a picker, and the numbers as the scene states them, either light itself (linear) or sRGB. The badge says which, and changes it
// without changing the colour.
import { useRef, useState } from "preact/hooks";
import { words } from "../i18n";
import { pausingDrag } from "../state/scene";
import { decoded, encoded, picked, readColor, screenColor, writeLinear, writeText, type Rgb } from "./color";
import { NumberInput } from "./number-input";

export interface ColorFieldProps {
  id: string;
  label: string;
  help: string;
  /** as stated, or the default */
  value: unknown;
  /** the picture's transfer is `srgb` */
  isSrgb: boolean;
  hasAlpha: boolean;
  onValue: (value: unknown) => void;
  testid: string;
}

const kChannels = ["R", "G", "B"] as const;
const isLight = (value: number) => Number.isFinite(value) && value >= 0;

export function ColorField({ id, label, help, value, isSrgb, hasAlpha, onValue, testid }: ColorFieldProps) {
  const t = words.value.controls;
  const [draft, setDraft] = useState<string | undefined>(undefined);
  const pause = useRef(pausingDrag());
  const stated = readColor(value, isSrgb) ?? { linear: [0, 0, 0] as Rgb, isText: false };
  const { linear, alpha, isText } = stated;
  const write = (rgb: Rgb, asText = isText, withAlpha = alpha) =>
    onValue(asText ? writeText(rgb, isSrgb, withAlpha) : writeLinear(rgb, withAlpha));
  const brightest = Math.max(...linear);
  const text = typeof value === "string" ? value : "";
  const isHex = text.startsWith("#");
  // What stands in the fields: the numbers as they are stated, encoded where they are text.
  const shown = isText && isSrgb ? (linear.map((c) => Number(encoded(c).toPrecision(5))) as Rgb) : linear;
  const writeNumbers = (rgb: Rgb) => write(isText && isSrgb ? (rgb.map(decoded) as Rgb) : rgb);
  const takeText = (typed: string) => {
    setDraft(typed);
    const read = readColor(typed.trim(), isSrgb);
    if (read && (hasAlpha || read.alpha === undefined)) {
      onValue(typed.trim());
    }
  };
  return (
    <div class="color-field">
      <span class="swatch-frame" title={brightest > 1 ? t.brighter(Number(brightest.toPrecision(3))) : undefined}>
        <input
          id={id}
          class="swatch"
          type="color"
          value={screenColor(linear, isSrgb)}
          aria-description={help}
          data-testid={testid}
          onInput={(event) => {
            pause.current();
            write(picked(event.currentTarget.value, linear, isSrgb));
          }}
        />
        {brightest > 1 ? <span class="swatch-mark">×{Number(brightest.toPrecision(2))}</span> : null}
      </span>
      {isHex ? (
        <input
          class="number-input text-input"
          type="text"
          spellcheck={false}
          aria-label={`${label} (sRGB)`}
          aria-invalid={draft !== undefined && !readColor(draft.trim(), isSrgb)}
          value={draft ?? text}
          data-testid={`${testid}-text`}
          onInput={(event) => takeText(event.currentTarget.value)}
          onBlur={() => setDraft(undefined)}
        />
      ) : (
        kChannels.map((channel, i) => (
          <NumberInput
            key={channel}
            label={`${label} ${channel}`}
            value={shown[i]}
            step={0.05}
            isAllowed={isLight}
            range="≥ 0"
            testid={`${testid}-${channel.toLowerCase()}`}
            onValue={(next) => writeNumbers(shown.map((old, j) => (i === j ? next : old)) as Rgb)}
          />
        ))
      )}
      <button
        class="badge"
        type="button"
        data-help={isText ? t.statedSrgb : t.statedLinear}
        aria-label={isText ? t.statedSrgb : t.statedLinear}
        data-testid={`${testid}-space`}
        onClick={() => write(linear, !isText)}
      >
        {isText ? "sRGB" : "lin"}
      </button>
      {hasAlpha ? (
        <label class="alpha">
          α
          <NumberInput
            label={`${label} alpha`}
            value={alpha ?? 1}
            step={0.05}
            isAllowed={(n) => n >= 0 && n <= 1}
            range="0..1"
            testid={`${testid}-alpha`}
            onValue={(next) => write(linear, isText, next === 1 ? undefined : next)}
          />
        </label>
      ) : null}
    </div>
  );
}
