// The explanation of the chosen pixel: what src/explain puts into the slot, and what to do where no pixel is chosen.
import { words } from "../i18n";
import { selectedPixel } from "../state/selection";
import { entriesOf } from "../state/slots";
import { IconButton } from "./icon-button";
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
        <IconButton icon="close" label={t.clear} isSmall onClick={() => (selectedPixel.value = undefined)} />
      </header>
      {entriesOf("explain").map(({ id, component: Component }) => (
        <Component key={id} />
      ))}
    </div>
  );
}
