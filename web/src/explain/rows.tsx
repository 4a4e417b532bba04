// The panel's small parts: tables of three channels, pairs of a name and a value, sections that open.
import type { ComponentChildren } from "preact";
import { numberText } from "../plots/number";
import { explainWords } from "./words";

export function Section({
  id,
  title,
  open = true,
  children,
}: {
  id: string;
  title: ComponentChildren;
  open?: boolean;
  children: ComponentChildren;
}) {
  return (
    <details class="x-section" open={open} data-testid={`explain-${id}`}>
      <summary>{title}</summary>
      <div class="x-body">{children}</div>
    </details>
  );
}

/** Names and values, in two columns. */
export function Facts({ children }: { children: ComponentChildren }) {
  return <dl class="x-facts">{children}</dl>;
}

export function Fact({ name, children }: { name: ComponentChildren; children: ComponentChildren }) {
  return (
    <>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </>
  );
}

/** Rows of three channels, or of x, y and z. */
export function Triples({ label, axes = "rgb", children }: { label: string; axes?: "rgb" | "xyz"; children: ComponentChildren }) {
  const t = explainWords.value;
  const heads = axes === "xyz" ? ["x", "y", "z"] : [t.red, t.green, t.blue];
  return (
    <table class="x-triples" aria-label={label}>
      <thead>
        <tr>
          <td />
          {heads.map((head, i) => (
            <th key={head} scope="col" class={axes === "rgb" ? `x-channel-${i}` : undefined}>
              {axes === "rgb" ? <abbr title={head}>{"RGB"[i]}</abbr> : head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>{children}</tbody>
    </table>
  );
}

export function Triple({
  name,
  value,
  kind = "",
  digits = 4,
}: {
  name: ComponentChildren;
  value: readonly number[];
  kind?: string;
  digits?: number;
}) {
  const isDark = value.every((number) => number === 0);
  return (
    <tr class={`${kind}${isDark ? " x-zero" : ""}`}>
      <th scope="row">{name}</th>
      {[0, 1, 2].map((i) => (
        <td key={i}>{numberText(value[i]!, digits)}</td>
      ))}
    </tr>
  );
}

/** A vector's letter in its colour, as in the picture. */
export function Letter({ name }: { name: "N" | "L" | "V" | "R" | "H" }) {
  return <b class={`x-letter x-${name}`}>{name}</b>;
}

export const named = (index: number, name: string): string => (name === "" ? String(index + 1) : name);
