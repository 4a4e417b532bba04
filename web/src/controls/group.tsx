// A titled part of a panel, which may be folded away.
import type { ComponentChildren } from "preact";

export function Group({
  title,
  children,
  isOpen = true,
  isFoldable = false,
  testid,
}: {
  title: string;
  children: ComponentChildren;
  isOpen?: boolean;
  isFoldable?: boolean;
  testid?: string;
}) {
  if (!isFoldable) {
    return (
      <section class="group" data-testid={testid}>
        <h2 class="group-title">{title}</h2>
        {children}
      </section>
    );
  }
  return (
    <details class="group" open={isOpen} data-testid={testid}>
      <summary class="group-title">{title}</summary>
      {children}
    </details>
  );
}
