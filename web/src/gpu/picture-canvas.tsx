// Bytes as a canvas of just their size; CSS makes it as large as its place.
import { useLayoutEffect, useRef } from "preact/hooks";

interface Bytes {
  width: number;
  height: number;
  bytes: Uint8ClampedArray<ArrayBuffer>;
}

export function BytesCanvas({ picture, testid }: { picture: Bytes | undefined; testid: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element || !picture) {
      return;
    }
    if (element.width !== picture.width || element.height !== picture.height) {
      element.width = picture.width;
      element.height = picture.height;
    }
    element.getContext("2d")?.putImageData(new ImageData(picture.bytes, picture.width, picture.height), 0, 0);
  }, [picture]);
  return <canvas ref={canvas} class="picture" data-testid={testid} data-ready={picture !== undefined} aria-hidden="true" />;
}
