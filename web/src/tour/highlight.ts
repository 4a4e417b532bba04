// Pointing at a control: its panel is opened, it is scrolled into view, and it carries an attribute that the style sheet draws a ring around.
import { isSheetOpen, panelTab } from "../state/settings";
import type { ControlRef } from "./lesson";

const kAttribute = "data-tour-target";

let observer: MutationObserver | undefined;

const isNarrow = () => typeof matchMedia === "function" && matchMedia("(max-width: 860px)").matches;
const isCalm = () => typeof matchMedia === "function" && matchMedia("(prefers-reduced-motion: reduce)").matches;

function clear(): void {
  observer?.disconnect();
  observer = undefined;
  document.querySelectorAll(`[${kAttribute}]`).forEach((element) => element.removeAttribute(kAttribute));
}

/**
 * Points at a control, or at none. On narrow screens its panel would hide the picture: it opens only where `opens` says so. Panels draw
 * themselves later, and again when the scene changes: the ring follows.
 */
export function pointAt(control: ControlRef | undefined, opens = !isNarrow()): void {
  if (typeof document === "undefined") {
    return;
  }
  clear();
  if (!control) {
    return;
  }
  if (opens) {
    panelTab.value = control.tab;
    isSheetOpen.value = true;
  }
  let isScrolled = false;
  const mark = () => {
    const element = document.querySelector<HTMLElement>(`[data-testid="${CSS.escape(control.testid)}"]`);
    if (!element) {
      return;
    }
    for (
      let folded = element.closest("details:not([open])");
      folded;
      folded = folded.parentElement?.closest("details:not([open])") ?? null
    ) {
      folded.setAttribute("open", "");
    }
    if (!element.hasAttribute(kAttribute)) {
      element.setAttribute(kAttribute, "");
    }
    if (!isScrolled) {
      isScrolled = true;
      // a sheet that is only being opened has no height yet in which there were a middle
      element.scrollIntoView({ block: isNarrow() ? "start" : "center", behavior: isCalm() ? "auto" : "smooth" });
    }
  };
  mark();
  const panel = document.querySelector(".panel");
  if (panel) {
    observer = new MutationObserver(mark);
    observer.observe(panel, { childList: true, subtree: true });
  }
}

/** The same by a button: the control gets the focus, too. */
export function goTo(control: ControlRef): void {
  pointAt(control, true);
  requestAnimationFrame(() => {
    const element = document.querySelector<HTMLElement>(`[data-testid="${CSS.escape(control.testid)}"]`);
    const inner = element?.matches("button, input, select")
      ? element
      : element?.querySelector<HTMLElement>("input, select, button, [tabindex='0']");
    inner?.focus({ preventScroll: true });
  });
}
