// A titled part of a panel, which may be folded away.
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";

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
  const wasOpen = useRef(false);
  if (!isFoldable) {
    return (
      <section class="group" data-testid={testid}>
        <h2 class="group-title">{title}</h2>
        {children}
      </section>
    );
  }
  // What has been opened is not shut under the reader's hands.
  wasOpen.current ||= isOpen;
  return (
    <details class="group" open={wasOpen.current} data-testid={testid}>
      <summary class="group-title">{title}</summary>
      {children}
    </details>
  );
}
