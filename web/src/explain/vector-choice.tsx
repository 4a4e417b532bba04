// Which vectors are drawn in the picture, and of which light: the legend and its switches.
import type { Explanation } from "../engine/types";
import { LightChoice } from "./light-choice";
import { drawn, kDrawn, type DrawnName } from "./state";
import { explainWords } from "./words";

const isLetter = (name: DrawnName) => name.length === 1;

export function VectorChoice({ e }: { e: Explanation }) {
  const t = explainWords.value;
  if (e.fragments.length === 0) {
    return null;
  }
  return (
    <fieldset class="x-vectors">
      <legend>{t.vectors}</legend>
      {kDrawn.map((name) => (
        <label key={name} title={t.vectorNames[name]}>
          <input
            type="checkbox"
            checked={drawn.value[name]}
            onChange={(event) => (drawn.value = { ...drawn.value, [name]: event.currentTarget.checked })}
            data-testid={`draw-${name}`}
          />
          <span class={isLetter(name) ? `x-letter x-${name}` : "x-word"}>{isLetter(name) ? name : t.vectorNames[name]}</span>
          {isLetter(name) ? <span class="visually-hidden">{t.vectorNames[name]}</span> : null}
        </label>
      ))}
      <LightChoice testId="draw-light" />
    </fieldset>
  );
}
