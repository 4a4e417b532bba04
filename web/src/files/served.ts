// The model of `lustro lab FILE`: the program that serves the page serves it, too, and tells when it changes on disk.
import type { EngineFile, SceneDoc } from "../engine/types";
import { words } from "../i18n";
import { loading } from "../state/files";
import { retract, say, sayError } from "../state/messages";
import { isTable } from "../state/path";
import { resetScene, scene } from "../state/scene";
import { openFiles, reloadFiles } from "./open";
import type { LinkContent } from "./link";
import { showSight } from "./sight";

interface ServedModel {
  entry: string;
  files: { path: string; size: number; version: string | number }[];
  version: string | number;
  /** why what is served may be older than the file on disk */
  error?: string;
}

const kAbout = "served";

const pathUrl = (path: string) => `./api/files/${path.split("/").map(encodeURIComponent).join("/")}`;

/** What has been fetched, by path and version: a change of one texture does not fetch the mesh again. */
const fetched = new Map<string, { version: string | number; bytes: Uint8Array }>();

/** On a web host of static files a file of this name says `null`: asking for what is not there would look like an error. */
async function fetchModel(): Promise<ServedModel | undefined> {
  try {
    const answer = await fetch("./api/model", { cache: "no-store" });
    const model: unknown = answer.status === 200 ? JSON.parse(await answer.text()) : undefined;
    return isTable(model) && typeof model["entry"] === "string" && Array.isArray(model["files"])
      ? (model as unknown as ServedModel)
      : undefined;
  } catch {
    return undefined;
  }
}

async function fetchFiles(model: ServedModel): Promise<EngineFile[]> {
  const total = model.files.reduce((sum, { size }) => sum + size, 0) || 1;
  let done = 0;
  const files: EngineFile[] = [];
  for (const { path, size, version } of model.files) {
    loading.value = { what: path, share: done / total };
    let known = fetched.get(path);
    if (known?.version !== version) {
      const answer = await fetch(pathUrl(path), { cache: "no-store" });
      if (!answer.ok) {
        throw new Error(`${path}: ${answer.status} ${answer.statusText}`);
      }
      known = { version, bytes: new Uint8Array(await answer.arrayBuffer()) };
      fetched.set(path, known);
    }
    files.push({ path, bytes: known.bytes });
    done += size;
  }
  return files;
}

/** Loads what is served and follows its changes; false: nothing is served. link: what the address restores on top of it. */
export async function followServed(link: LinkContent | undefined): Promise<boolean> {
  const model = await fetchModel();
  if (!model) {
    return false;
  }
  let stated: SceneDoc | undefined;
  let version = model.version;
  try {
    if (await openFiles(await fetchFiles(model), { entry: model.entry, source: "served" })) {
      stated = scene.peek();
      if (link) {
        resetScene(link.scene, { attached: link.attached });
        showSight(link.sight ?? {});
      }
    }
  } catch (problem) {
    sayError(problem, kAbout);
  } finally {
    loading.value = undefined;
  }
  if (model.error !== undefined) {
    say("error", model.error, kAbout);
  }
  const events = new EventSource(`./api/events?version=${encodeURIComponent(String(model.version))}`);
  const onChange = async () => {
    const now = await fetchModel();
    if (!now || now.version === version) {
      return;
    }
    version = now.version;
    try {
      const files = await fetchFiles(now);
      if (stated === undefined) {
        await openFiles(files, { entry: now.entry, source: "served" });
        stated = scene.peek();
      } else {
        stated = (await reloadFiles(files, now.entry, stated)) ?? stated;
      }
      retract(kAbout);
    } catch (problem) {
      sayError(problem, kAbout);
    } finally {
      loading.value = undefined;
    }
  };
  events.onmessage = (event) => {
    const data = JSON.parse(String(event.data)) as { version?: string | number; error?: string };
    if (data.error !== undefined) {
      say("error", data.error, kAbout);
    } else if (data.version !== version) {
      void onChange();
    } else {
      retract(kAbout);
    }
  };
  events.onerror = () => {
    if (events.readyState === EventSource.CLOSED) {
      say("note", words.peek().files.serverGone, kAbout);
    }
  };
  return true;
}
