// The pixels around the chosen one, enlarged: it shows what anti-aliasing mixed, and arrow keys walk the chosen pixel from here.
import { useLayoutEffect, useRef } from "preact/hooks";
import { effect } from "@preact/signals";
import { fullSize, picture } from "../state/picture";
import { selectedPixel } from "../state/selection";
import { explainWords } from "./words";

const kAround = 6;
const kSide = 2 * kAround + 1;
const kSteps: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export function movePixel(dx: number, dy: number): void {
  const pixel = selectedPixel.peek();
  const { width, height } = fullSize.peek();
  if (pixel) {
    selectedPixel.value = { x: Math.max(0, Math.min(width - 1, pixel.x + dx)), y: Math.max(0, Math.min(height - 1, pixel.y + dy)) };
  }
}

export function Lens() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(
    () =>
      effect(() => {
        const shown = picture.value;
        const pixel = selectedPixel.value;
        const full = fullSize.value;
        const context = canvas.current?.getContext("2d");
        if (!shown || !pixel || !context || full.width === 0) {
          return;
        }
        const image = context.createImageData(kSide, kSide);
        for (let y = 0; y < kSide; y++) {
          for (let x = 0; x < kSide; x++) {
            const px = Math.floor(((pixel.x + x - kAround + 0.5) * shown.width) / full.width);
            const py = Math.floor(((pixel.y + y - kAround + 0.5) * shown.height) / full.height);
            if (px >= 0 && py >= 0 && px < shown.width && py < shown.height) {
              const at = (py * shown.width + px) * 4;
              image.data.set(shown.bytes.subarray(at, at + 4), (y * kSide + x) * 4);
            }
          }
        }
        context.putImageData(image, 0, 0);
      }),
    [],
  );
  const onKey = (event: KeyboardEvent) => {
    const step = kSteps[event.key];
    if (step) {
      const size = event.shiftKey ? 10 : 1;
      movePixel(step[0] * size, step[1] * size);
      event.preventDefault();
    }
  };
  const onClick = (event: MouseEvent) => {
    const rect = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const step = (at: number, size: number) => Math.floor((at / size) * kSide) - kAround;
    movePixel(step(event.clientX - rect.left, rect.width), step(event.clientY - rect.top, rect.height));
  };
  return (
    <div
      class="x-lens"
      role="application"
      tabIndex={0}
      aria-label={explainWords.value.lens}
      title={explainWords.value.lens}
      onKeyDown={onKey}
      onClick={onClick}
      data-testid="explain-lens"
    >
      <canvas ref={canvas} width={kSide} height={kSide} />
      <i
        style={{
          width: `${100 / kSide}%`,
          height: `${100 / kSide}%`,
          left: `${(100 * kAround) / kSide}%`,
          top: `${(100 * kAround) / kSide}%`,
        }}
      />
    </div>
  );
}
