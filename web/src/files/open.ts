// Opening: files become the engine's, the scene that they make becomes the page's.
import { batch } from "@preact/signals";
import type { EngineFile, SceneDoc } from "../engine/types";
import { words } from "../i18n";
import { engine } from "../state/engine";
import { entryOf } from "../engine/client";
import { kNoFiles, loading, openedFiles, type OpenedFiles } from "../state/files";
import { readable, retract, say, sayError } from "../state/messages";
import { labDoc, resetScene, scene } from "../state/scene";
import { selectedLight, selectedPixel, selectObject } from "../state/selection";
import { filesOf, type LinkContent } from "./link";
import { showSight } from "./sight";

const kAbout = "open";
const kMostNotes = 4;
const isPicture = (path: string) => /\.(png|jpe?g|webp)$/i.test(path);
const folderOf = (path: string) => path.slice(0, path.lastIndexOf("/") + 1);

/** The scene of a link whose files are not here: it is shown once they are opened. */
let awaited: LinkContent | undefined;

function sayNotes(notes: readonly string[]): void {
  if (notes.length > 0) {
    const shown = notes.slice(0, kMostNotes).map(readable).join("\n");
    say("warning", notes.length > kMostNotes ? `${shown}\n${words.peek().files.moreNotes(notes.length - kMostNotes)}` : shown, "notes");
  }
}

function show(doc: SceneDoc, files: OpenedFiles, attached: readonly number[] = []): void {
  batch(() => {
    openedFiles.value = files;
    selectedPixel.value = undefined;
    selectedLight.value = undefined;
    selectObject(0);
    resetScene(doc, { attached });
  });
}

/** A scene that needs no files: an example, a link. */
export function openScene(doc: SceneDoc, attached: readonly number[] = []): void {
  awaited = undefined;
  retract("notes");
  show(doc, kNoFiles, attached);
}

/** What a link restores; where it needs files that are not here, says which. */
export function openLink(link: LinkContent): void {
  const isHere = link.files.every((path) => openedFiles.peek().files.some((file) => file.path.endsWith(path)));
  if (isHere) {
    show(link.scene, openedFiles.peek(), link.attached);
    showSight(link.sight ?? {});
    return;
  }
  awaited = link;
  say("note", words.peek().files.linkNeeds(link.files.join(", ")), "link");
}

/** Pictures alone join what is open: they are there for textures. */
async function addPictures(files: readonly EngineFile[]): Promise<void> {
  const before = openedFiles.peek();
  const hasModel = before.files.length > 0 && before.entry !== "";
  const entry = hasModel ? before.entry : "scene.json";
  const folder = folderOf(entry);
  const added = files.map(({ path, bytes }) => ({ path: folder + path.slice(path.lastIndexOf("/") + 1), bytes }));
  const kept = before.files.filter(({ path }) => !added.some((file) => file.path === path));
  // A scene that was opened from no file is one for the engine, so that the pictures have a place beside it.
  const own = hasModel ? [] : [{ path: entry, bytes: new TextEncoder().encode(JSON.stringify(scene.peek())) }];
  const all = [...kept.filter(({ path }) => hasModel || path !== entry), ...own, ...added];
  await engine.peek()!.open(all, entry);
  openedFiles.value = { ...before, source: hasModel ? before.source : "dropped", entry, files: all };
  say("success", words.peek().files.picturesAdded(added.map(({ path }) => path).join(", ")), kAbout);
}

/** Opens a model or a scene with all that belongs to it. Errors become messages; the scene before stays then. */
export async function openFiles(
  files: readonly EngineFile[],
  { entry, source = "dropped" as OpenedFiles["source"] }: { entry?: string; source?: OpenedFiles["source"] } = {},
): Promise<boolean> {
  const current = engine.peek();
  if (!current || files.length === 0) {
    return false;
  }
  try {
    retract("notes");
    retract("link");
    retract(kAbout);
    if (entry === undefined && files.every(({ path }) => isPicture(path))) {
      await addPictures(files);
      return true;
    }
    loading.value = { what: entry ?? files[0]!.path };
    const opened = await current.open([...files], entry);
    const name = entry ?? entryOf([...files]) ?? files[0]!.path;
    const link = awaited;
    const fits = link !== undefined && filesOf(link.scene).every((path) => files.some((file) => file.path.endsWith(path)));
    awaited = fits ? undefined : awaited;
    show(
      fits ? link.scene : opened.scene,
      { source, entry: name, files, cameras: opened.cameras, animations: opened.animations },
      fits ? link.attached : [],
    );
    if (fits) {
      showSight(link.sight ?? {});
    }
    sayNotes(opened.notes);
    return true;
  } catch (problem) {
    sayError(problem, kAbout);
    return false;
  } finally {
    loading.value = undefined;
  }
}

/** Newer versions of the files that are open: what the reader changed on the page stays, the camera above all. */
export async function reloadFiles(files: readonly EngineFile[], entry: string, statedBefore: SceneDoc): Promise<SceneDoc | undefined> {
  const current = engine.peek();
  if (!current) {
    return undefined;
  }
  try {
    const opened = await current.open([...files], entry);
    retract(kAbout);
    batch(() => {
      openedFiles.value = { ...openedFiles.peek(), entry, files, cameras: opened.cameras, animations: opened.animations };
      const merged = mergedScene(statedBefore, scene.peek(), opened.scene);
      if (merged !== scene.peek()) {
        resetScene(merged, { keep: true, attached: labDoc.peek().attached });
      }
    });
    sayNotes(opened.notes);
    return opened.scene;
  } catch (problem) {
    sayError(problem, kAbout);
    return undefined;
  }
}

/** Of these the page's edits win over the file's. */
const kOfTheReader = new Set(["camera", "shading"]);

/** Key by key: what the reader changed stays where the file did not change it; where both did, the camera and the shading stay. */
export function mergedScene(fileBefore: SceneDoc, page: SceneDoc, fileNow: SceneDoc): SceneDoc {
  const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);
  const merged: Record<string, unknown> = {};
  for (const key of new Set([...Object.keys(fileNow), ...Object.keys(page)])) {
    const keepsPage = same(fileBefore[key], fileNow[key]) || (kOfTheReader.has(key) && !same(fileBefore[key], page[key]));
    const value = keepsPage ? page[key] : fileNow[key];
    if (value !== undefined) {
      merged[key] = value;
    }
  }
  return same(merged, page) ? page : (merged as unknown as SceneDoc);
}
