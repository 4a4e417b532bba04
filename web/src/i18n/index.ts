// The words of the language that is chosen.
import { computed, type ReadonlySignal } from "@preact/signals";
import { language } from "../state/settings";
import { en, type Words } from "./en";
import { it } from "./it";

export type { Words };
export const words: ReadonlySignal<Words> = computed(() => (language.value === "it" ? it : en));
