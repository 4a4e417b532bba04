// The explanation of the chosen pixel: what src/explain puts into the slot, and what to do where no pixel is chosen.
import { words } from "../i18n";
import { selectedPixel } from "../state/selection";
import { entriesOf } from "../state/slots";
import { Icon } from "./icons";

export function ExplainPanel() {
  const t = words.value.explain;
  const pixel = selectedPixel.value;
  if (!pixel) {
    return (
      <div class="empty" data-testid="explain-empty">
        <Icon name="pixel" />
        <h2>{t.empty}</h2>
        <p>{t.howTo}</p>
      </div>
    );
  }
  return (
    <div class="explain" data-testid="explain">
      <header class="section-head">
        <h2>{t.pixel(pixel.x, pixel.y)}</h2>
        <button class="tool small" type="button" title={t.clear} aria-label={t.clear} onClick={() => (selectedPixel.value = undefined)}>
          <Icon name="close" />
        </button>
      </header>
      {entriesOf("explain").map(({ id, component: Component }) => (
        <Component key={id} />
      ))}
    </div>
  );
}
