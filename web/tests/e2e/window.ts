// What the page gives to the browser's console (main.tsx), as the tests use it.
import type { Engine, Picture, SceneDoc } from "../../src/engine/types";

declare global {
  interface Window {
    lustro: {
      engine: { value: Engine | undefined };
      scene: { value: SceneDoc };
      picture: { value: Picture | undefined };
      update: (path: string, value: unknown) => void;
    };
  }
}
