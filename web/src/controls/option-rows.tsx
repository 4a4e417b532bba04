// Rows of the options' kinds that take more than a widget: numbers with sliders, words, terms, matrices.
import { computed } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { Option } from "../engine/types";
import { words } from "../i18n";
import { wordHelpOf, wordLabelOf } from "../i18n/options";
import { view } from "../state/picture";
import { length, subtract } from "../stage/vector";
import { isAllowed, niceSize, rangeText, sliderRange } from "./defaults";
import { NumberInput } from "./number-input";
import { Row } from "./row";
import { Segmented } from "./segmented";
import { Select } from "./select";
import { Slider } from "./slider";

/** More words than this are a list to unfold. */
const kMostSegments = 5;

const diagonal = computed(() => {
  const v = view.value;
  const size = v ? length(subtract(v.upper, v.lower)) : 1;
  return size > 0 && Number.isFinite(size) ? size : 1;
});

/** The diagonal of what is shown; it changes with the objects, not with every picture. */
export function sceneSize(): number {
  return diagonal.value;
}

export function stepOf(option: Option, name: string, size: number): number {
  if (option.kind === "integer") {
    return 1;
  }
  if (option.unit === "world units") {
    return niceSize(size) / 100;
  }
  const range = sliderRange(name, option, size);
  return range && range.scale === "linear"
    ? Math.max(0.001, niceSize((range.to - range.from) / 100))
    : name.endsWith("shininess") || option.unit === "degrees"
      ? 1
      : 0.05;
}

export type Common = Omit<Parameters<typeof Row>[0], "children">;
export type SetValue = (value: unknown) => void;

export function NumberRow({
  common,
  name,
  option,
  value,
  own,
  fallback,
  set,
}: {
  common: Common;
  name: string;
  option: Option;
  value: unknown;
  own: unknown;
  fallback: unknown;
  set: SetValue;
}) {
  const size = sceneSize();
  if (option.allowed && option.allowed.length > 0) {
    return (
      <Row {...common} isGroup>
        <Segmented
          id={common.id}
          labelledBy={`${common.id}-label`}
          segments={option.allowed.map((n) => ({ value: String(n), label: String(n) }))}
          value={String(value)}
          onValue={(text) => set(Number(text))}
          testid={`${common.testid}-input`}
        />
      </Row>
    );
  }
  const range = sliderRange(name, option, size);
  const shown = typeof value === "number" ? value : undefined;
  return (
    <Row {...common}>
      <div class="number-field">
        {range ? (
          <Slider
            label={common.label}
            value={shown ?? (range.from + range.to) / 2}
            range={range}
            isInteger={option.kind === "integer"}
            isAllowed={(n) => isAllowed(option, n)}
            onValue={set}
            testid={`${common.testid}-slider`}
          />
        ) : null}
        <NumberInput
          id={common.id}
          help={common.help}
          value={option.optional ? (own as number | undefined) : shown}
          placeholder={typeof fallback === "number" ? String(Number(fallback.toPrecision(4))) : words.value.controls.auto}
          step={stepOf(option, name, size)}
          isAllowed={(n) => isAllowed(option, n)}
          range={rangeText(option)}
          onValue={set}
          onEmpty={() => set(undefined)}
          testid={`${common.testid}-input`}
        />
      </div>
    </Row>
  );
}

const segmentsOf = (name: string, option: Option) =>
  option.words.map(({ word, help }) => ({ value: word, label: wordLabelOf(name, word), help: wordHelpOf(name, word, help) }));

export function WordRow({
  common,
  name,
  option,
  value,
  isStated,
  set,
  pictures,
  only,
}: {
  common: Common;
  name: string;
  option: Option;
  value: string | undefined;
  isStated: boolean;
  set: SetValue;
  pictures?: Readonly<Record<string, ComponentChildren>> | undefined;
  only?: readonly string[] | undefined;
}) {
  const segments = segmentsOf(name, option)
    .filter(({ value }) => !only || only.includes(value))
    .map((segment) => ({ ...segment, ...(pictures?.[segment.value] ? { picture: pictures[segment.value] } : {}) }));
  const asScene = { value: "", label: words.value.controls.asDefault, help: option.default };
  const choices = option.optional ? [asScene, ...segments] : segments;
  const current = option.optional && !isStated ? "" : (value ?? "");
  const chosen = segments.find((segment) => segment.value === current);
  const help = chosen ? `${common.help}. ${chosen.label}: ${chosen.help}` : common.help;
  const take = (word: string) => set(word === "" ? undefined : word);
  if (choices.length <= kMostSegments) {
    return (
      <Row {...common} help={help} isGroup isTall={pictures !== undefined || choices.length > 3}>
        <Segmented
          id={common.id}
          labelledBy={`${common.id}-label`}
          segments={choices}
          value={current}
          onValue={take}
          isLarge={pictures !== undefined}
          testid={`${common.testid}-input`}
        />
      </Row>
    );
  }
  return (
    <Row {...common} help={help}>
      <Select id={common.id} help={common.help} options={choices} value={current} onValue={take} testid={`${common.testid}-input`} />
    </Row>
  );
}

interface ValueRow<Value> {
  common: Common;
  name: string;
  option: Option;
  value: Value;
  set: SetValue;
}

export function TermsRow({ common, name, option, value, set }: ValueRow<readonly string[]>) {
  const all = option.words.map(({ word }) => word);
  return (
    <Row {...common} isGroup isTall>
      <div class="terms" role="group" aria-labelledby={`${common.id}-label`}>
        {option.words.map(({ word, help }) => {
          const isOn = value.includes(word);
          const take = () => {
            const next = all.filter((term) => (term === word ? !isOn : value.includes(term)));
            set(next.length === all.length ? undefined : next);
          };
          return (
            <button
              key={word}
              class={`term ${word}`}
              type="button"
              aria-pressed={isOn}
              data-help={wordHelpOf(name, word, help)}
              data-testid={`${common.testid}-${word}`}
              onClick={take}
            >
              {wordLabelOf(name, word)}
            </button>
          );
        })}
      </div>
    </Row>
  );
}

export function MatrixRow({ common, option, value, set }: { common: Common; option: Option; value: readonly number[]; set: SetValue }) {
  const columns = option.kind === "matrix" ? 4 : 3;
  // The last row of a matrix that places an object is 0, 0, 0, 1.
  const free = 12;
  return (
    <Row {...common} isGroup isTall>
      <div class="matrix" style={{ "--columns": String(columns) }} role="group" aria-labelledby={`${common.id}-label`}>
        {value.slice(0, free).map((entry, i) => (
          <NumberInput
            key={i}
            label={`${common.label} ${Math.floor(i / columns) + 1}, ${(i % columns) + 1}`}
            value={entry}
            step={0.05}
            isAllowed={(n) => isAllowed({ ...option, kind: "number" }, n)}
            range={rangeText(option)}
            onValue={(next) => set(value.map((old, j) => (i === j ? next : old)))}
            testid={`${common.testid}-${i}`}
          />
        ))}
      </div>
    </Row>
  );
}

/** A word for each of a picture's axes, stated as one where they are the same. The value may be anything that a scene's text holds. */
export function WrapRow({ common, name, option, value, set }: ValueRow<unknown>) {
  const stated: readonly unknown[] = Array.isArray(value) ? value : [value];
  const [u = "", v = u] = stated.filter((word) => typeof word === "string");
  const choices = segmentsOf(name, option);
  const chosen = choices.filter((choice) => choice.value === u || choice.value === v);
  const help = `${common.help}. ${chosen.map((choice) => `${choice.label}: ${choice.help}`).join(". ")}`;
  const take = (nextU: string, nextV: string) => set(nextU === nextV ? nextU : [nextU, nextV]);
  return (
    <Row {...common} help={help} isGroup>
      <div class="axis-words" role="group" aria-labelledby={`${common.id}-label`}>
        {(
          [
            ["u", u, (word: string) => take(word, v)],
            ["v", v, (word: string) => take(u, word)],
          ] as const
        ).map(([axis, word, onValue]) => (
          <label key={axis}>
            <span>{axis}</span>
            <Select
              id={`${common.id}-${axis}`}
              help={help}
              options={choices}
              value={word}
              onValue={onValue}
              testid={`${common.testid}-input-${axis}`}
            />
          </label>
        ))}
      </div>
    </Row>
  );
}
