// The address and the scene: a link's fragment is opened at the start and when it changes; while the scene changes the fragment follows, so that a
// reload or a bookmark brings everything back.
import { effect } from "@preact/signals";
import { words } from "../i18n";
import { engineStatus } from "../state/engine";
import { errorText, say } from "../state/messages";
import { isDragging, labDoc } from "../state/scene";
import { kStartScene } from "./examples";
import { filesOf, linkHash, readLink, type LinkContent } from "./link";
import { openLink, openScene } from "./open";
import { followServed } from "./served";
import { currentSight, showSight } from "./sight";

const kQuiet = 700;
/** Addresses that are longer are not kept by all browsers. */
const kLongest = 60_000;

let written = "";

function linkOfAddress(): LinkContent | undefined {
  try {
    return readLink(location.hash);
  } catch (problem) {
    say("error", words.peek().files.brokenLink(errorText(problem)), "link");
    return undefined;
  }
}

/**
 * What the page begins with: a link, what `lustro lab` serves, or the start scene; then the address follows the scene.
 * ready  the engine has started
 */
export async function openAddress(ready: Promise<void>): Promise<void> {
  const link = linkOfAddress();
  const needsFiles = link !== undefined && link.files.length > 0;
  openScene(link && !needsFiles ? link.scene : kStartScene, link && !needsFiles ? link.attached : []);
  if (link && !needsFiles) {
    showSight(link.sight ?? {});
  }
  await ready;
  const isServed = await followServed(needsFiles ? link : undefined);
  if (needsFiles && !isServed) {
    openLink(link);
  }
  followScene();
  window.addEventListener("hashchange", () => {
    if (location.hash !== written) {
      const changed = linkOfAddress();
      if (changed) {
        openLink(changed);
      }
    }
  });
}

function followScene(): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let first: unknown = labDoc.peek();
  const firstSight = JSON.stringify(currentSight());
  effect(() => {
    const doc = labDoc.value;
    const sight = currentSight();
    const isQuiet = !isDragging.value && engineStatus.value !== "starting";
    clearTimeout(timer);
    if ((doc === first && JSON.stringify(sight) === firstSight) || !isQuiet) {
      return;
    }
    first = undefined;
    timer = setTimeout(() => {
      const hash = linkHash({ ...doc, files: filesOf(doc.scene), sight });
      written = hash.length <= kLongest ? hash : "#";
      history.replaceState(null, "", written);
    }, kQuiet);
  });
}
