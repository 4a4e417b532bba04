// A small picture of an example: drawn by the engine when the examples are first looked at; of those that need files, one that was drawn before.
import { signal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import type { Thumbnail } from "../controls/thumbnails";
import { engine } from "../state/engine";
import type { Example } from "./examples";

const kWidth = 208;
const kHeight = 130;
const drawn = signal<Readonly<Record<string, Thumbnail>>>({});
const asked = new Set<string>();

async function draw(example: Example): Promise<void> {
  const current = engine.peek();
  if (!current || example.files || asked.has(example.name)) {
    return;
  }
  asked.add(example.name);
  try {
    const picture = await current.render({ scene: example.scene, width: kWidth, height: kHeight, samples: 4, aside: true }, true);
    drawn.value = { ...drawn.peek(), [example.name]: { width: picture.width, height: picture.height, bytes: picture.bytes } };
  } catch {
    // The example itself says what is wrong when it is opened.
  }
}

export function ExamplePicture({ example }: { example: Example }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const picture = drawn.value[example.name];
  useEffect(() => void draw(example), [example]);
  useLayoutEffect(() => {
    if (picture) {
      canvas.current?.getContext("2d")?.putImageData(new ImageData(picture.bytes, picture.width, picture.height), 0, 0);
    }
  }, [picture]);
  return example.picture ? (
    <img class="example-picture" src={example.picture} width={kWidth} height={kHeight} alt="" />
  ) : (
    <canvas ref={canvas} class="example-picture" width={kWidth} height={kHeight} aria-hidden="true" />
  );
}
