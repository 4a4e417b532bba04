// One of the small pictures that the engine draws at the start.
import { useLayoutEffect, useRef } from "preact/hooks";
import { thumbnails } from "./thumbnails";

export function ThumbnailView({ name }: { name: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const drawn = thumbnails.value[name];
  useLayoutEffect(() => {
    if (drawn) {
      canvas.current?.getContext("2d")?.putImageData(new ImageData(drawn.bytes, drawn.width, drawn.height), 0, 0);
    }
  }, [drawn]);
  return (
    <canvas
      ref={canvas}
      class={drawn ? "thumbnail" : "thumbnail waiting"}
      width={drawn?.width ?? 96}
      height={drawn?.height ?? 96}
      aria-hidden="true"
    />
  );
}
