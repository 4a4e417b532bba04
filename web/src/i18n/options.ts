// Names, helps and units of the library's options in the page's language. English helps come from the engine; names are made of the keys unless
// stated here.
import type { Option } from "../engine/types";
import { language } from "../state/settings";
import { labelsEn, wordLabels } from "./options-en";
import { optionsIt, unitsIt, wordsIt } from "./options-it";

function fromKey(key: string): string {
  const text = key.replaceAll("_", " ").replaceAll("-", " ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function lastKey(name: string): string {
  return name.slice(name.lastIndexOf(".") + 1);
}

function sentence(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** name: `shading.two_sided` */
export function labelOf(name: string): string {
  return (language.value === "it" ? optionsIt[name]?.[0] : undefined) ?? labelsEn[name] ?? fromKey(lastKey(name));
}

export function helpOf(name: string, option: Option): string {
  return (language.value === "it" ? optionsIt[name]?.[1] : undefined) ?? sentence(option.help);
}

export function unitOf(option: Option): string {
  return language.value === "it" ? (unitsIt[option.unit] ?? option.unit) : option.unit;
}

/** Words of the materials' own lighting and cull are those of `shading`. */
function wordTable(name: string): string {
  return name.replace(/^materials\.\*\.(lighting|cull)$/, "shading.$1");
}

export function wordLabelOf(name: string, word: string): string {
  const italian = language.value === "it" ? wordsIt[`${wordTable(name)}: ${word}`]?.[0] : undefined;
  return italian ?? wordLabels[word] ?? fromKey(word);
}

export function wordHelpOf(name: string, word: string, help: string): string {
  const italian = language.value === "it" ? wordsIt[`${wordTable(name)}: ${word}`]?.[1] : undefined;
  return italian ?? sentence(help);
}
