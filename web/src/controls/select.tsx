// One of many words.
import type { Segment } from "./segmented";

export function Select({
  id,
  label,
  help,
  options,
  value,
  onValue,
  testid,
}: {
  id: string;
  label?: string;
  help?: string;
  options: readonly Segment[];
  value: string;
  onValue: (value: string) => void;
  testid: string;
}) {
  return (
    <select
      id={id}
      class="select"
      aria-label={label}
      aria-description={help}
      value={value}
      data-testid={testid}
      onChange={(event) => onValue(event.currentTarget.value)}
    >
      {options.map((option) => (
        <option key={option.value} value={option.value} title={option.help}>
          {option.label}
        </option>
      ))}
    </select>
  );
}
