// What is under the pointer, in one line over the picture: its bytes at once, the surface and the shares of the terms when the engine has them.
import { numberText } from "../plots/number";
import { fullSize, picture } from "../state/picture";
import { hoveredPixel } from "../state/selection";
import { panelTab } from "../state/settings";
import { kTerms, luminance } from "./equation";
import { named } from "./rows";
import { hoveredExplanation } from "./state";
import { explainWords } from "./words";

function bytesAt(x: number, y: number): number[] | undefined {
  const shown = picture.value;
  const full = fullSize.value;
  if (!shown || full.width === 0) {
    return undefined;
  }
  const px = Math.min(shown.width - 1, Math.floor(((x + 0.5) * shown.width) / full.width));
  const py = Math.min(shown.height - 1, Math.floor(((y + 0.5) * shown.height) / full.height));
  const at = (py * shown.width + px) * 4;
  return [...shown.bytes.subarray(at, at + 4)];
}

export function Reader() {
  const t = explainWords.value;
  const pixel = hoveredPixel.value;
  const bytes = pixel && panelTab.value === "explain" ? bytesAt(pixel.x, pixel.y) : undefined;
  if (!pixel || !bytes) {
    return null;
  }
  const e = hoveredExplanation.value;
  const parts = e ? kTerms.map((term) => ({ term, amount: Math.max(luminance(e[term]), 0) })).filter(({ amount }) => amount > 0) : [];
  const f = e?.fragments[0];
  return (
    <div class="x-reader" aria-hidden="true" data-testid="explain-reader">
      <span class="x-swatch" style={{ "--swatch": `rgb(${bytes.slice(0, 3).join(" ")} / ${bytes[3]! / 255})` }} />
      <span class="number">
        {pixel.x}, {pixel.y}
      </span>
      <span class="number">{bytes.slice(0, 3).join(" ")}</span>
      {f ? <span>{[named(f.object, f.object_name), f.material_name].filter((word) => word !== "").join(" · ")}</span> : null}
      {parts.length > 0 ? (
        <span class="x-bar">
          {parts.map(({ term, amount }) => (
            <span key={term} class={`x-term-${term}`} style={{ flexGrow: amount }} title={`${t.terms[term]} ${numberText(amount, 3)}`} />
          ))}
        </span>
      ) : null}
    </div>
  );
}
