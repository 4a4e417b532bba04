// The examples, each with what it shows.
import { words } from "../i18n";
import { sayError } from "../state/messages";
import { Dialog } from "./dialog";
import { fetchExample, forWindow, kExamples, type Example } from "./examples";
import { ExamplePicture } from "./example-picture";
import { openFiles, openScene } from "./open";

async function show(example: Example): Promise<void> {
  if (!example.files) {
    openScene(forWindow(example.scene));
    return;
  }
  try {
    await openFiles(await fetchExample(example), { entry: example.entry ?? "scene.json" });
  } catch (problem) {
    sayError(problem, "open");
  }
}

export function ExamplesDialog({ onClose }: { onClose: () => void }) {
  const t = words.value.examples;
  return (
    <Dialog title={t.title} onClose={onClose} testid="examples-dialog">
      <ul class="examples">
        {kExamples.map((example) => (
          <li key={example.name}>
            <button
              class="example"
              type="button"
              data-testid={`example-${example.name}`}
              onClick={() => {
                onClose();
                void show(example);
              }}
            >
              <ExamplePicture example={example} />
              <strong>{t.names[example.name][0]}</strong>
              <span>{t.names[example.name][1]}</span>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
