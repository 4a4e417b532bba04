// The stage: the engine's picture, letterboxed, sharp to the device's pixel, with layers and overlays above it.
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { effect } from "@preact/signals";
import { words } from "../i18n";
import { fullSize, isDrawing, isPictureFinal, picture } from "../state/picture";
import { scene } from "../state/scene";
import { entriesOf, pointerTool } from "../state/slots";
import { pictureRect } from "./projection";
import { Notices } from "./notices";
import { attachPointer } from "./pointer";
import { startRenderLoop } from "./render-loop";

/** The engine takes no larger pictures. */
const kLargestSide = 16384;

/** The shape that the scene states, width by height; undefined: the picture fills the stage. */
function statedShape(): { width: number; height: number } | undefined {
  const { width, height } = scene.value.image ?? {};
  if (width === undefined && height === undefined) {
    return undefined;
  }
  return { width: typeof width === "number" ? width : 1024, height: typeof height === "number" ? height : 768 };
}

/** Lays the picture into the stage: whole device pixels, so that none is blurred. */
function layOut(stage: { width: number; height: number }): void {
  const ratio = window.devicePixelRatio || 1;
  const shape = statedShape();
  let { width, height } = stage;
  if (shape && width > 0 && height > 0) {
    const scale = Math.min(width / shape.width, height / shape.height);
    width = shape.width * scale;
    height = shape.height * scale;
  }
  const pixels = {
    width: Math.min(kLargestSide, Math.max(1, Math.round(width * ratio))),
    height: Math.min(kLargestSide, Math.max(1, Math.round(height * ratio))),
  };
  if (stage.width === 0 || stage.height === 0) {
    return;
  }
  const rect = { width: pixels.width / ratio, height: pixels.height / ratio };
  pictureRect.value = {
    ...rect,
    left: Math.round(((stage.width - rect.width) / 2) * ratio) / ratio,
    top: Math.round(((stage.height - rect.height) / 2) * ratio) / ratio,
  };
  const before = fullSize.peek();
  if (before.width !== pixels.width || before.height !== pixels.height) {
    fullSize.value = pixels;
  }
}

/** The engine's picture as a canvas of just its size; CSS makes a small one large. */
function PictureCanvas() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(
    () =>
      effect(() => {
        const drawn = picture.value;
        const element = canvas.current;
        if (!drawn || !element) {
          return;
        }
        if (element.width !== drawn.width || element.height !== drawn.height) {
          element.width = drawn.width;
          element.height = drawn.height;
        }
        element.getContext("2d")?.putImageData(new ImageData(drawn.bytes, drawn.width, drawn.height), 0, 0);
      }),
    [],
  );
  return (
    <canvas ref={canvas} class="picture" data-testid="picture" data-final={isPictureFinal.value && !isDrawing.value} aria-hidden="true" />
  );
}

function Overlays() {
  const { width, height } = pictureRect.value;
  return (
    <svg class="overlay" width={width} height={height} viewBox={`0 0 ${width} ${height}`} data-testid="overlay">
      {entriesOf("overlay").map(({ id, component: Component }) => (
        <Component key={id} />
      ))}
    </svg>
  );
}

export function Stage() {
  const frame = useRef<HTMLDivElement>(null);
  const inner = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = frame.current!;
    const measure = () => layOut({ width: element.clientWidth, height: element.clientHeight });
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    window.addEventListener("resize", measure);
    const stopLayout = effect(() => {
      statedShape();
      measure();
    });
    const stopLoop = startRenderLoop();
    const detach = attachPointer(inner.current!);
    return () => {
      observer.disconnect();
      window.removeEventListener("resize", measure);
      stopLayout();
      stopLoop();
      detach();
    };
  }, []);
  const rect = pictureRect.value;
  const place = { left: `${rect.left}px`, top: `${rect.top}px`, width: `${rect.width}px`, height: `${rect.height}px` };
  return (
    <div class="stage" ref={frame}>
      <div
        class="stage-picture"
        ref={inner}
        style={{ ...place, cursor: pointerTool.value?.cursor ?? "grab" }}
        tabIndex={0}
        role="application"
        aria-label={words.value.stage.label}
        aria-describedby="stage-help"
        data-testid="stage"
      >
        <PictureCanvas />
        {entriesOf("layer").map(({ id, component: Component }) => (
          <Component key={id} />
        ))}
        <Overlays />
      </div>
      <p id="stage-help" class="visually-hidden">
        {words.value.stage.help}
      </p>
      <Notices />
      <div class="stage-tools" role="toolbar" aria-label={words.value.stage.tools}>
        {entriesOf("stageTool").map(({ id, component: Component }) => (
          <Component key={id} />
        ))}
      </div>
    </div>
  );
}
