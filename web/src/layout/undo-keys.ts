// Ctrl+Z, Ctrl+Shift+Z and Ctrl+Y, wherever the keyboard is, but for fields in which text is written: those undo by themselves.
import { redo, undo } from "../state/scene";

export function listenForUndo(): () => void {
  const onKey = (event: KeyboardEvent) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (event.target as Element).matches?.("input[type=text], textarea")) {
      return;
    }
    const key = event.key.toLowerCase();
    if (key === "z" || key === "y") {
      event.preventDefault();
      if (key === "y" || event.shiftKey) {
        redo();
      } else {
        undo();
      }
    }
  };
  window.addEventListener("keydown", onKey);
  return () => window.removeEventListener("keydown", onKey);
}
