// A part of the scene that is there or not (fog, shadows, a floor): a switch in its title, its settings where it is on.
import type { ComponentChildren } from "preact";
import { words } from "../i18n";
import { helpOf, labelOf } from "../i18n/options";
import { options } from "../state/engine";
import { at, update } from "../state/scene";
import { Switch } from "./switch";

export interface ToggleGroupProps {
  /** a key of the scene: `fog` */
  name: string;
  /** what is stated when it is switched on */
  onValue: () => unknown;
  children: ComponentChildren;
}

export function ToggleGroup({ name, onValue, children }: ToggleGroupProps) {
  const option = options.value.get(name);
  const stated = at(name).value;
  const isOn = stated !== undefined && stated !== false;
  if (!option) {
    return null;
  }
  const help = helpOf(name, option);
  return (
    <section class="group" data-testid={`group-${name}`}>
      <div class="toggle-title">
        <label class="group-title" for={`toggle-${name}`} data-help={help}>
          {words.value.sceneParts[name as keyof typeof words.value.sceneParts] ?? labelOf(name)}
        </label>
        <Switch
          id={`toggle-${name}`}
          help={help}
          value={isOn}
          onValue={(on) => update(name, on ? onValue() : undefined)}
          testid={`toggle-${name}`}
        />
      </div>
      {isOn ? children : null}
    </section>
  );
}
