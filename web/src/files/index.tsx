// In and out, put into their places on the page: the header's buttons, the drop zone, paste, the address.
import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { words } from "../i18n";
import { Icon, type IconName } from "../layout/icons";
import { loading } from "../state/files";
import { sayError } from "../state/messages";
import { register } from "../state/slots";
import { ExamplesDialog } from "./examples-dialog";
import { ExportDialog } from "./export-dialog";
import { openFiles } from "./open";
import { readChosen, readTransfer } from "./read";
import { ShareDialog } from "./share-dialog";
import "./files.css";

type DialogName = "examples" | "export" | "share";

const dialog = signal<DialogName | undefined>(undefined);

function DialogButton({ name, icon }: { name: DialogName; icon: IconName }) {
  const text = words.value.header[name];
  return (
    <button class="tool" type="button" aria-label={text} title={text} data-testid={name} onClick={() => (dialog.value = name)}>
      <Icon name={icon} />
      <span class="label">{text}</span>
    </button>
  );
}

function OpenButton() {
  const input = useRef<HTMLInputElement>(null);
  const text = words.value.header.open;
  const take = async (element: HTMLInputElement) => {
    try {
      if (element.files) {
        await openFiles(await readChosen(element.files));
      }
    } catch (problem) {
      sayError(problem, "open");
    } finally {
      loading.value = undefined;
      element.value = "";
    }
  };
  return (
    <>
      <button
        class="tool"
        type="button"
        aria-label={text}
        title={words.value.files.openHelp}
        data-testid="open"
        onClick={() => input.current?.click()}
      >
        <Icon name="open" />
        <span class="label">{text}</span>
      </button>
      <input
        ref={input}
        class="visually-hidden"
        type="file"
        multiple
        tabIndex={-1}
        aria-hidden="true"
        data-testid="open-input"
        onChange={(event) => void take(event.currentTarget)}
      />
    </>
  );
}

function HeaderButtons() {
  return (
    <>
      <DialogButton name="examples" icon="examples" />
      <OpenButton />
      <DialogButton name="export" icon="export" />
      <DialogButton name="share" icon="share" />
    </>
  );
}

const isOver = signal(false);

async function takeTransfer(transfer: DataTransfer): Promise<void> {
  try {
    await openFiles(await readTransfer(transfer));
  } catch (problem) {
    sayError(problem, "open");
  } finally {
    loading.value = undefined;
  }
}

/** Text that may be a scene file. */
async function takeText(text: string): Promise<void> {
  if (text.trimStart().startsWith("{")) {
    await openFiles([{ path: "scene.json", bytes: new TextEncoder().encode(text) }], { entry: "scene.json" });
  }
}

function DropZone() {
  useEffect(() => {
    let depth = 0;
    const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
    const onEnter = (event: DragEvent) => {
      if (hasFiles(event)) {
        event.preventDefault();
        depth++;
        isOver.value = true;
      }
    };
    const onLeave = (event: DragEvent) => {
      if (hasFiles(event) && --depth <= 0) {
        depth = 0;
        isOver.value = false;
      }
    };
    const onOver = (event: DragEvent) => {
      if (hasFiles(event)) {
        event.preventDefault();
      }
    };
    const onDrop = (event: DragEvent) => {
      depth = 0;
      isOver.value = false;
      if (event.dataTransfer && hasFiles(event)) {
        event.preventDefault();
        void takeTransfer(event.dataTransfer);
      }
    };
    const onPaste = (event: ClipboardEvent) => {
      const target = event.target as Element | null;
      if (!event.clipboardData || target?.closest?.("input, textarea")) {
        return;
      }
      if (event.clipboardData.files.length > 0) {
        event.preventDefault();
        void takeTransfer(event.clipboardData);
      } else {
        void takeText(event.clipboardData.getData("text/plain"));
      }
    };
    window.addEventListener("dragenter", onEnter);
    window.addEventListener("dragleave", onLeave);
    window.addEventListener("dragover", onOver);
    window.addEventListener("drop", onDrop);
    window.addEventListener("paste", onPaste);
    return () => {
      window.removeEventListener("dragenter", onEnter);
      window.removeEventListener("dragleave", onLeave);
      window.removeEventListener("dragover", onOver);
      window.removeEventListener("drop", onDrop);
      window.removeEventListener("paste", onPaste);
    };
  }, []);
  const t = words.value.files;
  const now = loading.value;
  const close = () => (dialog.value = undefined);
  return (
    <>
      {isOver.value ? (
        <div class="drop-zone" data-testid="drop-zone">
          <p>{t.drop}</p>
          <p>{t.dropHelp}</p>
        </div>
      ) : null}
      {now ? (
        <div class="loading" role="status" data-testid="loading">
          <span>{t.loading(now.what)}</span>
          <progress {...(now.share === undefined ? {} : { value: now.share, max: 1 })} />
        </div>
      ) : null}
      {dialog.value === "examples" ? <ExamplesDialog onClose={close} /> : null}
      {dialog.value === "export" ? <ExportDialog onClose={close} /> : null}
      {dialog.value === "share" ? <ShareDialog onClose={close} /> : null}
    </>
  );
}

register("header", { id: "files", order: 10, component: HeaderButtons });
register("floating", { id: "files", order: 10, component: DropZone });
