// Help of whatever has `data-help`: shown beside it while the pointer rests on it or the keyboard is there.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";

const kDelay = 350;

const shown = signal<{ text: string; left: number; top: number; isAbove: boolean } | undefined>(undefined);

function place(target: Element): void {
  const text = target.getAttribute("data-help");
  if (!text) {
    return;
  }
  const rect = target.getBoundingClientRect();
  const isAbove = rect.bottom > window.innerHeight * 0.7;
  const left = Math.max(8, Math.min(rect.left, window.innerWidth - 268));
  shown.value = { text, left, top: isAbove ? rect.top - 6 : rect.bottom + 6, isAbove };
}

export function Tooltip() {
  useEffect(() => {
    let timer = 0;
    const hide = () => {
      window.clearTimeout(timer);
      shown.value = undefined;
    };
    const onOver = (event: Event) => {
      const target = (event.target as Element).closest?.("[data-help]");
      window.clearTimeout(timer);
      if (!target) {
        shown.value = undefined;
        return;
      }
      timer = window.setTimeout(() => place(target), kDelay);
    };
    const onFocus = (event: Event) => {
      const target = (event.target as Element).closest?.("[data-help]");
      if (target && (event.target as Element).matches(":focus-visible")) {
        place(target);
      }
    };
    const onKey = (event: KeyboardEvent) => event.key === "Escape" && hide();
    document.addEventListener("pointerover", onOver);
    document.addEventListener("pointerdown", hide);
    document.addEventListener("focusin", onFocus);
    document.addEventListener("focusout", hide);
    document.addEventListener("scroll", hide, true);
    document.addEventListener("keydown", onKey);
    return () => {
      hide();
      document.removeEventListener("pointerover", onOver);
      document.removeEventListener("pointerdown", hide);
      document.removeEventListener("focusin", onFocus);
      document.removeEventListener("focusout", hide);
      document.removeEventListener("scroll", hide, true);
      document.removeEventListener("keydown", onKey);
    };
  }, []);
  const tip = shown.value;
  if (!tip) {
    return null;
  }
  return (
    <div class={`tooltip${tip.isAbove ? " above" : ""}`} role="tooltip" style={{ left: `${tip.left}px`, top: `${tip.top}px` }}>
      {tip.text}
    </div>
  );
}
