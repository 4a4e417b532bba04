// A window over the page that the browser itself keeps in front, closes by Escape, and gives the keyboard to.
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { words } from "../i18n";
import { IconButton } from "../layout/icon-button";

export function Dialog({
  title,
  onClose,
  children,
  testid,
}: {
  title: string;
  onClose: () => void;
  children: ComponentChildren;
  testid: string;
}) {
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    element.current?.showModal();
  }, []);
  return (
    <dialog
      ref={element}
      class="dialog"
      aria-label={title}
      data-testid={testid}
      onClose={onClose}
      onClick={(event) => event.target === element.current && element.current?.close()}
    >
      <div class="dialog-content">
        <header class="section-head">
          <h2>{title}</h2>
          <IconButton
            icon="close"
            label={words.value.messages.dismiss}
            isSmall
            testid={`${testid}-close`}
            onClick={() => element.current?.close()}
          />
        </header>
        {children}
      </div>
    </dialog>
  );
}
