// A row for a positive number that is turned up and down by factors: a slider of logarithms, and the number itself.
import { NumberInput } from "./number-input";
import { Row } from "./row";
import { Slider } from "./slider";

const kRange = { from: 0.01, to: 100, scale: "log" } as const;
const isPositive = (n: number) => Number.isFinite(n) && n > 0;

export function FactorRow({
  id,
  label,
  help,
  value,
  step,
  onValue,
}: {
  /** of the row, and what its tests call it */
  id: string;
  label: string;
  help: string;
  value: number;
  step: number;
  onValue: (value: number) => void;
}) {
  return (
    <Row id={id} label={label} help={help} testid={id}>
      <div class="number-field">
        <Slider label={label} value={value} range={kRange} isAllowed={isPositive} onValue={onValue} testid={`${id}-slider`} />
        <NumberInput
          id={id}
          value={Number(value.toPrecision(4))}
          step={step}
          isAllowed={isPositive}
          range="> 0"
          onValue={onValue}
          testid={`${id}-input`}
        />
      </div>
    </Row>
  );
}
