// One line of a panel: the option's name with its help, the widget, and a way back to the default.
import type { ComponentChildren } from "preact";
import { words } from "../i18n";
import { showsHelp } from "../state/settings";
import { Icon } from "../layout/icons";

export interface RowProps {
  /** of the widget that the label names; none where the widget is a group with a label of its own */
  id: string;
  label: string;
  help: string;
  unit?: string;
  isGroup?: boolean;
  /** the widget takes the whole width, below the label */
  isTall?: boolean;
  /** how to go back to the default; absent where the default holds */
  onReset?: (() => void) | undefined;
  /** it does nothing as things are, and why */
  idle?: string | undefined;
  testid: string;
  children: ComponentChildren;
}

export function Row({ id, label, help, unit, isGroup, isTall, onReset, idle, testid, children }: RowProps) {
  const t = words.value.controls;
  const text = (
    <>
      {label}
      {unit ? <span class="unit"> {unit}</span> : null}
    </>
  );
  const said = idle ? `${help}. ${idle}` : help;
  return (
    <div class={`row${isTall ? " tall" : ""}${idle ? " idle" : ""}`} data-testid={testid}>
      {isGroup ? (
        <span id={`${id}-label`} class="row-label" data-help={said}>
          {text}
        </span>
      ) : (
        <label for={id} class="row-label" data-help={said}>
          {text}
        </label>
      )}
      <div class="row-widget">{children}</div>
      {onReset ? (
        <button
          class="reset"
          type="button"
          title={t.reset}
          aria-label={`${t.reset}: ${label}`}
          data-testid={`${testid}-reset`}
          onClick={onReset}
        >
          <Icon name="reset" />
        </button>
      ) : (
        <span class="reset-place" />
      )}
      {showsHelp.value === "on" ? <p class="row-help">{said}</p> : null}
    </div>
  );
}
