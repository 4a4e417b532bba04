// A text of a lesson: formulas between dollars, terms between asterisks, code between backticks.
import { Tex } from "../explain/tex";
import type { Text } from "./lesson";
import { spoken } from "./words";

export function Prose({ text }: { text: Text }) {
  const parts = spoken(text).split(/(\$[^$]+\$|\*\*[^*]+\*\*|\*[^*]+\*|`[^`]+`)/);
  return (
    <>
      {parts.map((part, index) =>
        part.startsWith("$") ? (
          <Tex key={index} tex={part.slice(1, -1)} />
        ) : part.startsWith("**") ? (
          <strong key={index}>{part.slice(2, -2)}</strong>
        ) : part.startsWith("*") ? (
          <em key={index}>{part.slice(1, -1)}</em>
        ) : part.startsWith("`") ? (
          <code key={index}>{part.slice(1, -1)}</code>
        ) : (
          part
        ),
      )}
    </>
  );
}
