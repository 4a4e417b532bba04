// On or off.
export function Switch({
  id,
  label,
  help,
  value,
  onValue,
  testid,
}: {
  id: string;
  label?: string;
  help?: string;
  value: boolean;
  onValue: (value: boolean) => void;
  testid: string;
}) {
  return (
    <input
      id={id}
      class="switch"
      type="checkbox"
      role="switch"
      aria-label={label}
      aria-description={help}
      checked={value}
      data-testid={testid}
      onChange={(event) => onValue(event.currentTarget.checked)}
    />
  );
}
