// What can be taken away: the picture in any size, the scene file, the exact command, the shaders.
import { useEffect, useState } from "preact/hooks";
import { NumberInput } from "../controls/number-input";
import { Segmented } from "../controls/segmented";
import { words } from "../i18n";
import { engine } from "../state/engine";
import { errorText } from "../state/messages";
import { fullSize } from "../state/picture";
import { scene } from "../state/scene";
import { Dialog } from "./dialog";
import { copyText, download } from "./download";
import { pngOf } from "./png";

const kSamples = [1, 2, 4, 8, 16];
const isSide = (n: number) => Number.isInteger(n) && n >= 1 && n <= 16384;

function statedSamples(): number {
  const { samples } = scene.peek().image ?? {};
  return typeof samples === "number" ? samples : 4;
}

/** A name for files: of the first object. */
function baseName(): string {
  const object = scene.peek().objects[0];
  const name =
    object?.name ??
    object?.mesh
      .replace(/^primitive:/, "")
      .split("/")
      .at(-1)
      ?.replace(/\.[^.]*$/, "") ??
    "";
  return name.replaceAll(/[^\w-]+/g, "_") || "lustro";
}

function PictureExport({
  size,
  setSize,
  samples,
  setSamples,
}: {
  size: { width: number; height: number };
  setSize: (size: { width: number; height: number }) => void;
  samples: number;
  setSamples: (n: number) => void;
}) {
  const t = words.value.exporting;
  const [isBusy, setBusy] = useState(false);
  const [hash, setHash] = useState("");
  // Said here: the page's messages lie behind the dialog.
  const [problem, setProblem] = useState("");
  const full = fullSize.value;
  const sizes = [
    { label: t.asShown, ...full },
    { label: "1920 × 1080", width: 1920, height: 1080 },
    { label: "3840 × 2160", width: 3840, height: 2160 },
    { label: "2048 × 2048", width: 2048, height: 2048 },
  ];
  const render = async (wantsFile: boolean) => {
    const current = engine.peek();
    if (!current) {
      return;
    }
    setBusy(true);
    setProblem("");
    try {
      const drawn = await current.render({ scene: scene.peek(), ...size, samples, hash: !wantsFile }, true);
      if (wantsFile) {
        download(`${baseName()}.png`, pngOf(drawn), "image/png");
      } else {
        setHash(drawn.hash ?? "");
      }
    } catch (reason) {
      setProblem(errorText(reason));
    } finally {
      setBusy(false);
    }
  };
  return (
    <section class="group" data-testid="export-picture">
      <h3 class="group-title">{t.picture}</h3>
      <div class="export-size">
        <NumberInput
          label={t.width}
          value={size.width}
          step={16}
          isAllowed={isSide}
          range="1..16384"
          onValue={(width) => setSize({ ...size, width })}
          testid="export-width"
        />
        ×
        <NumberInput
          label={t.height}
          value={size.height}
          step={16}
          isAllowed={isSide}
          range="1..16384"
          onValue={(height) => setSize({ ...size, height })}
          testid="export-height"
        />
      </div>
      <div class="export-samples">
        <span aria-hidden="true">{t.samples}</span>
        <Segmented
          id="export-samples"
          label={t.samples}
          segments={kSamples.map((n) => ({ value: String(n), label: `${n}` }))}
          value={String(samples)}
          onValue={(n) => setSamples(Number(n))}
          testid="export-samples"
        />
      </div>
      <div class="choices wide">
        {sizes.map(({ label, width, height }) => (
          <button
            key={label}
            class="term plain"
            type="button"
            aria-pressed={size.width === width && size.height === height}
            onClick={() => setSize({ width, height })}
          >
            {label}
          </button>
        ))}
      </div>
      <div class="actions">
        <button class="action main" type="button" disabled={isBusy} data-testid="export-png" onClick={() => void render(true)}>
          {isBusy ? words.value.stage.drawing : t.png}
        </button>
        <button
          class="action"
          type="button"
          disabled={isBusy}
          data-help={t.hashHelp}
          data-testid="export-hash"
          onClick={() => void render(false)}
        >
          {t.hash}
        </button>
        <output class="hash" data-testid="export-hash-value">
          {hash}
        </output>
      </div>
      {problem ? (
        <p class="problem" role="alert" data-testid="export-problem">
          {problem}
        </p>
      ) : null}
    </section>
  );
}

/** A text with buttons to copy and to save it. */
function TextExport({
  title,
  help,
  text,
  name,
  type,
  testid,
}: {
  title: string;
  help: string;
  text: string;
  name?: string;
  type: string;
  testid: string;
}) {
  const t = words.value.exporting;
  const [isCopied, setCopied] = useState(false);
  return (
    <section class="group" data-testid={testid}>
      <h3 class="group-title">{title}</h3>
      <p class="row-help">{help}</p>
      <pre class="export-text" tabIndex={0} data-testid={`${testid}-text`}>
        {text}
      </pre>
      <div class="actions">
        <button
          class="action"
          type="button"
          disabled={text === ""}
          data-testid={`${testid}-copy`}
          onClick={() => void copyText(text).then((done) => setCopied(done))}
        >
          {isCopied ? t.copied : t.copy}
        </button>
        {name ? (
          <button
            class="action"
            type="button"
            disabled={text === ""}
            data-testid={`${testid}-save`}
            onClick={() => download(name, text, type)}
          >
            {t.save(name)}
          </button>
        ) : null}
      </div>
    </section>
  );
}

export function ExportDialog({ onClose }: { onClose: () => void }) {
  const t = words.value.exporting;
  const [size, setSize] = useState(fullSize.peek());
  const [samples, setSamples] = useState(statedSamples());
  const [texts, setTexts] = useState({ file: "", command: "", commandFile: "", vertex: "", fragment: "", problem: "" });
  useEffect(() => {
    const current = engine.peek();
    if (!current) {
      return;
    }
    let isOver = false;
    const ask = async () => {
      const [file, line, glsl] = await Promise.allSettled([
        current.sceneFile(scene.value),
        current.commandLine({ scene: scene.value, ...size, samples }),
        current.glsl(scene.value),
      ]);
      const problems = [file, line, glsl].filter((answer) => answer.status === "rejected").map((answer) => errorText(answer.reason));
      if (!isOver) {
        setTexts({
          file: file.status === "fulfilled" ? file.value : "",
          command: line.status === "fulfilled" ? line.value.command : "",
          commandFile: line.status === "fulfilled" ? (line.value.file ?? "") : "",
          vertex: glsl.status === "fulfilled" ? glsl.value.vertex : "",
          fragment: glsl.status === "fulfilled" ? glsl.value.fragment : "",
          problem: problems.join("\n"),
        });
      }
    };
    void ask();
    return () => {
      isOver = true;
    };
  }, [size.width, size.height, samples, scene.value]);
  const base = baseName();
  return (
    <Dialog title={t.title} onClose={onClose} testid="export-dialog">
      <PictureExport {...{ size, setSize, samples, setSamples }} />
      {texts.problem ? <p class="problem">{texts.problem}</p> : null}
      <TextExport
        title={t.command}
        help={texts.commandFile ? t.commandWithFile : t.commandHelp}
        text={texts.command}
        type="text/plain"
        testid="export-command"
      />
      <TextExport
        title={t.scene}
        help={t.sceneHelp}
        text={texts.commandFile || texts.file}
        name={texts.commandFile ? "scene.json" : `${base}.json`}
        type="application/json"
        testid="export-scene"
      />
      <TextExport title={t.vertex} help={t.glslHelp} text={texts.vertex} name={`${base}.vert`} type="text/plain" testid="export-vertex" />
      <TextExport title={t.fragment} help="" text={texts.fragment} name={`${base}.frag`} type="text/plain" testid="export-fragment" />
    </Dialog>
  );
}
