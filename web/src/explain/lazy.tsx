// A component whose code is fetched when it is first shown: KaTeX and the plots are large, and a first look at the page needs neither.
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { sayError } from "../state/messages";

export function lazily(load: () => Promise<{ default: ComponentType }>): ComponentType {
  const loaded = signal<ComponentType | undefined>(undefined);
  let isLoading = false;
  return function Lazy() {
    useEffect(() => {
      if (!isLoading) {
        isLoading = true;
        load().then(
          (module) => (loaded.value = module.default),
          (problem: unknown) => {
            isLoading = false;
            sayError(problem, "explain");
          },
        );
      }
    }, []);
    const Loaded = loaded.value;
    return Loaded ? <Loaded /> : <p aria-busy="true">…</p>;
  };
}
