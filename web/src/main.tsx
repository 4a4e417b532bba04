// The page's beginning: styles, what registers itself, the engine, and the page itself.
import { effect } from "@preact/signals";
import { render } from "preact";
import "./styles/index.css";
import "./parts";
import { drawThumbnails } from "./controls/thumbnails";
import { App } from "./app";
import { openAddress } from "./files/address";
import { engine, libraryMaterials, startEngine } from "./state/engine";
import { isPictureFinal, picture } from "./state/picture";
import { scene, update } from "./state/scene";
import { createEngine } from "./engine/client";

const root = document.getElementById("app")!;
const benchmark = new URLSearchParams(location.search).get("benchmark");
if (benchmark === null) {
  render(<App />, root);
  void openAddress(startEngine(createEngine));
  // Thumbnails wait for the first picture.
  const stop = effect(() => {
    if (engine.value && isPictureFinal.value) {
      queueMicrotask(() => stop());
      void drawThumbnails(engine.value, libraryMaterials.value);
    }
  });
} else {
  const { startBenchmark } = await import("./benchmark/benchmark");
  await startBenchmark(root, Number(benchmark) || 1500);
}

// For the console of the browser, and for tests that ask the engine itself.
Object.assign(window, { lustro: { engine, scene, picture, update } });
