// A button that is an icon: its words are its tooltip and what screen readers say.
import { Icon, type IconName } from "./icons";

export function IconButton({
  icon,
  label,
  title = label,
  testid,
  isSmall = false,
  isDisabled = false,
  isExpanded,
  isPressed,
  onClick,
}: {
  icon: IconName;
  label: string;
  /** the tooltip, where it says more than the label */
  title?: string;
  testid?: string;
  isSmall?: boolean;
  isDisabled?: boolean;
  /** of one that opens something */
  isExpanded?: boolean;
  /** of one that is on or off */
  isPressed?: boolean;
  onClick: () => void;
}) {
  return (
    <button
      class={isSmall ? "tool small" : "tool"}
      type="button"
      title={title}
      aria-label={label}
      aria-expanded={isExpanded}
      aria-pressed={isPressed}
      disabled={isDisabled}
      data-testid={testid}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
