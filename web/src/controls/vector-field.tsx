// A few numbers in a line: a position, a direction, two edges.
import { NumberInput } from "./number-input";

export interface VectorFieldProps {
  label: string;
  axes: readonly string[];
  value: readonly number[] | undefined;
  /** what holds where nothing is stated */
  implied?: readonly number[] | undefined;
  step: number;
  isAllowed: (value: number) => boolean;
  range?: string;
  onValue: (value: number[]) => void;
  testid: string;
}

const short = (value: number | undefined) => (value === undefined ? undefined : String(Number(value.toPrecision(3))));

export function VectorField({ label, axes, value, implied, step, isAllowed, range, onValue, testid }: VectorFieldProps) {
  return (
    <div class="vector-field">
      {axes.map((axis, i) => (
        <NumberInput
          key={axis}
          label={`${label} ${axis}`}
          value={value?.[i]}
          placeholder={short(implied?.[i]) ?? axis}
          step={step}
          isAllowed={isAllowed}
          range={range ?? ""}
          testid={`${testid}-${axis}`}
          onValue={(next) => {
            const before = value ?? implied ?? axes.map(() => 0);
            onValue(before.map((old, j) => (i === j ? next : old)));
          }}
        />
      ))}
    </div>
  );
}
