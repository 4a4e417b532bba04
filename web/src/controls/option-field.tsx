// The control of one key of the scene file, made from its entry in the library's table of options: the widget by its kind, its help, unit, range
// and default.
import { useMemo } from "preact/hooks";
import type { ComponentChildren } from "preact";
import type { Option } from "../engine/types";
import { words } from "../i18n";
import { helpOf, labelOf, unitOf } from "../i18n/options";
import { options } from "../state/engine";
import { pathSteps, pathText, type Path } from "../state/path";
import { at, update } from "../state/scene";
import { ColorField } from "./color-field";
import { defaultValue, isAllowed, rangeText } from "./defaults";
import { MatrixRow, NumberRow, sceneSize, stepOf, TermsRow, WordRow, WrapRow } from "./option-rows";
import { Row } from "./row";
import { Switch } from "./switch";
import { VectorField } from "./vector-field";

export interface OptionFieldProps {
  /** in the table of options: `shading.crease`, `lights[].position` */
  name: string;
  /** in the scene; the name itself where it has no lists */
  path?: Path;
  /** what holds where nothing is stated, if the page knows it better than the table */
  implied?: unknown;
  /** in place of update(path, value) */
  onValue?: (value: unknown) => void;
  /** in place of the scene's value at the path */
  value?: unknown;
  idle?: string | undefined;
  /** segments as tiles with these pictures */
  pictures?: Readonly<Record<string, ComponentChildren>>;
  /** only these words */
  only?: readonly string[];
}

const kAxes: Record<string, readonly string[]> = { vector: ["x", "y", "z"], pair: ["u", "v"], triple: ["r", "g", "b"] };

function idOf(path: Path): string {
  return `field-${pathSteps(path)
    .join("-")
    .replaceAll(/[^\w-]/g, "_")}`;
}

export function OptionField(props: OptionFieldProps) {
  const option = options.value.get(props.name);
  return option ? <Known {...props} option={option} /> : null;
}

function Known({ name, path = name, implied, onValue, value: given, idle, pictures, only, option }: OptionFieldProps & { option: Option }) {
  const key = pathText(path);
  const stated = useMemo(() => at(path), [key]);
  const own = given === undefined ? stated.value : given;
  const fallback = implied ?? defaultValue(option);
  const value = own ?? fallback;
  const set = (next: unknown) => (onValue ? onValue(next) : update(path, next));
  const reset = own === undefined ? undefined : () => set(undefined);
  const id = idOf(path);
  const label = labelOf(name);
  const help = helpOf(name, option);
  const testid = `option-${name.replaceAll("[]", "").replaceAll("*", "x").replaceAll(".", "-")}`;
  const common = { id, label, help, testid, idle, onReset: reset, unit: unitOf(option) };

  switch (option.kind) {
    case "boolean":
      return (
        <Row {...common}>
          <Switch id={id} help={help} value={value === true} onValue={set} testid={`${testid}-input`} />
        </Row>
      );
    case "integer":
    case "number":
      return <NumberRow {...{ common, name, option, value, own, fallback, set }} />;
    case "vector":
    case "pair":
    case "triple": {
      const list = typeof value === "number" ? [value, value, value] : (value as number[] | undefined);
      return (
        <Row {...common} isGroup>
          <VectorField
            label={label}
            axes={kAxes[option.kind]!}
            value={own === undefined && option.optional ? undefined : list}
            implied={list}
            step={stepOf(option, name, sceneSize())}
            isAllowed={(n) => isAllowed(option, n)}
            range={rangeText(option)}
            onValue={set}
            testid={`${testid}-input`}
          />
        </Row>
      );
    }
    case "color":
    case "color_alpha":
      return (
        <Row {...common}>
          <ColorField
            {...{ id, label, help, value, onValue: set, testid: `${testid}-input` }}
            isSrgb={transferIsSrgb()}
            hasAlpha={option.kind === "color_alpha"}
          />
        </Row>
      );
    case "word":
      return (
        <WordRow {...{ common, name, option, value: value as string | undefined, isStated: own !== undefined, set, pictures, only }} />
      );
    case "terms":
      return <TermsRow {...{ common, name, option, value: value as string[], set }} />;
    case "text":
      return (
        <Row {...common}>
          <input
            id={id}
            class="number-input text-input"
            type="text"
            aria-description={help}
            value={typeof own === "string" ? own : ""}
            placeholder={option.default === "" ? "" : words.value.controls.auto}
            data-testid={`${testid}-input`}
            onInput={(event) => set(event.currentTarget.value === "" ? undefined : event.currentTarget.value)}
          />
        </Row>
      );
    case "matrix":
    case "affine":
      return <MatrixRow {...{ common, option, value: value as number[], set }} />;
    case "wrap":
      return <WrapRow {...{ common, name, option, value, set }} />;
    default:
      return null;
  }
}

/** Text colours are encoded unless the picture's transfer is `none`. */
const transfer = at<string>("image.transfer");
export function transferIsSrgb(): boolean {
  return transfer.value !== "none";
}
