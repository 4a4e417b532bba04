// The link that restores everything that the scene states.
import { useState } from "preact/hooks";
import { words } from "../i18n";
import { labDoc } from "../state/scene";
import { copyText } from "./download";
import { Dialog } from "./dialog";
import { filesOf, linkHash } from "./link";
import { currentSight } from "./sight";

export function currentLink(): string {
  return linkHash({ ...labDoc.value, files: filesOf(labDoc.value.scene), sight: currentSight() });
}

export function ShareDialog({ onClose }: { onClose: () => void }) {
  const t = words.value.sharing;
  const [isCopied, setCopied] = useState(false);
  const url = `${location.href.replace(/#.*$/, "")}${currentLink()}`;
  const files = filesOf(labDoc.value.scene);
  return (
    <Dialog title={t.title} onClose={onClose} testid="share-dialog">
      <p>{t.help}</p>
      <textarea
        class="share-link"
        readOnly
        rows={4}
        aria-label={t.title}
        value={url}
        data-testid="share-link"
        onFocus={(event) => event.currentTarget.select()}
      />
      {files.length > 0 ? (
        <p class="problem" data-testid="share-files">
          {t.files(files.join(", "))}
        </p>
      ) : null}
      <div class="actions">
        <button
          class="action main"
          type="button"
          data-testid="share-copy"
          onClick={() => void copyText(url).then((done) => setCopied(done))}
        >
          {isCopied ? words.value.exporting.copied : t.copy}
        </button>
        <span class="muted">{t.size(url.length)}</span>
      </div>
    </Dialog>
  );
}
