// Formulas by KaTeX, with MathML for screen readers. The TeX is the page's own: names out of files never get into it.
import katex from "katex";
import "katex/dist/katex.min.css";
import { useMemo } from "preact/hooks";

export function Tex({ tex, block = false }: { tex: string; block?: boolean }) {
  const html = useMemo(() => katex.renderToString(tex, { displayMode: block, output: "htmlAndMathml", throwOnError: false }), [tex, block]);
  return <span class={block ? "x-tex block" : "x-tex"} dangerouslySetInnerHTML={{ __html: html }} />;
}
