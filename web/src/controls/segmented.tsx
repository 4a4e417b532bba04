// One of a few words, all in sight: radio buttons that look like one polished bar, or like tiles with a picture each.
import type { ComponentChildren } from "preact";

export interface Segment {
  value: string;
  label: string;
  help?: string;
  picture?: ComponentChildren;
}

export interface SegmentedProps {
  id: string;
  /** of the element that names the group */
  labelledBy?: string;
  label?: string;
  segments: readonly Segment[];
  value: string | undefined;
  onValue: (value: string) => void;
  isLarge?: boolean;
  testid: string;
}

export function Segmented({ id, labelledBy, label, segments, value, onValue, isLarge, testid }: SegmentedProps) {
  return (
    <div
      class={isLarge ? "segmented large" : "segmented"}
      role="radiogroup"
      aria-labelledby={labelledBy}
      aria-label={label}
      data-testid={testid}
    >
      {segments.map((segment) => (
        <label key={segment.value} class="segment" data-help={segment.help}>
          <input
            type="radio"
            name={id}
            value={segment.value}
            checked={segment.value === value}
            aria-description={segment.help}
            data-testid={`${testid}-${segment.value}`}
            onChange={() => onValue(segment.value)}
          />
          <span class="segment-face">
            {segment.picture}
            <span>{segment.label}</span>
          </span>
        </label>
      ))}
    </div>
  );
}
