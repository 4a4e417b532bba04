// A number that is typed, stepped by the arrow keys, and refused where it is outside of its range.
import { useState } from "preact/hooks";
import { words } from "../i18n";

export interface NumberInputProps {
  id?: string;
  /** for screen readers, where no <label> names it */
  label?: string;
  help?: string;
  value: number | undefined;
  /** shown where nothing is stated */
  placeholder?: string;
  step: number;
  isAllowed: (value: number) => boolean;
  range?: string;
  onValue: (value: number) => void;
  /** the field was emptied: back to the default */
  onEmpty?: () => void;
  testid?: string;
}

/** As few digits as say what matters. */
export function numberText(value: number): string {
  return Math.abs(value) >= 1e7 ? value.toPrecision(6) : String(Number(value.toPrecision(7)));
}

/** One step up or down, without the noise of binary fractions. */
function stepped(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toPrecision(12));
}

export function NumberInput({ id, label, help, value, placeholder, step, isAllowed, range, onValue, onEmpty, testid }: NumberInputProps) {
  const [draft, setDraft] = useState<string | undefined>(undefined);
  const shown = draft ?? (value === undefined ? "" : numberText(value));
  const typed = Number(shown.replace(",", "."));
  const isWrong = draft !== undefined && draft.trim() !== "" && !isAllowed(typed);
  const take = (text: string) => {
    setDraft(text);
    const number = Number(text.trim().replace(",", "."));
    if (text.trim() === "") {
      onEmpty?.();
    } else if (isAllowed(number)) {
      onValue(number);
    }
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const direction = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (direction !== 0) {
      event.preventDefault();
      const size = step * (event.shiftKey ? 10 : 1);
      const next = stepped((value ?? (Number(placeholder) || 0)) + direction * size, step);
      if (isAllowed(next)) {
        setDraft(undefined);
        onValue(next);
      }
    } else if (event.key === "Enter" || event.key === "Escape") {
      setDraft(undefined);
    }
  };
  return (
    <input
      id={id}
      class="number-input"
      type="text"
      inputMode="decimal"
      autocomplete="off"
      spellcheck={false}
      aria-label={label}
      aria-description={help}
      aria-invalid={isWrong}
      title={isWrong ? `${words.value.controls.allowed}: ${range ?? ""}` : undefined}
      value={shown}
      placeholder={placeholder}
      data-testid={testid}
      onInput={(event) => take(event.currentTarget.value)}
      onKeyDown={onKeyDown}
      onFocus={(event) => event.currentTarget.select()}
      onBlur={() => setDraft(undefined)}
    />
  );
}
