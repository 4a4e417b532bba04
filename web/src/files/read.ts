// Files from where people have them: a file chooser, a drop of files and folders, the clipboard.
import type { EngineFile } from "../engine/types";
import { loading } from "../state/files";

/** What a browser hands over, with a path of its own below the folder that was dropped. */
interface Found {
  path: string;
  file: File;
}

/** A folder's listing comes in parts. */
function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  return new Promise((resolve, reject) => {
    const next = () =>
      reader.readEntries((part) => {
        if (part.length === 0) {
          resolve(all);
        } else {
          all.push(...part);
          next();
        }
      }, reject);
    next();
  });
}

async function walk(entry: FileSystemEntry, found: Found[]): Promise<void> {
  const path = entry.fullPath.replace(/^\//, "");
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    found.push({ path, file });
  } else if (entry.isDirectory && !entry.name.startsWith(".")) {
    for (const inner of await entriesOf(entry as FileSystemDirectoryEntry)) {
      await walk(inner, found);
    }
  }
}

async function bytesOf(found: readonly Found[]): Promise<EngineFile[]> {
  const total = found.reduce((sum, { file }) => sum + file.size, 0) || 1;
  const files: EngineFile[] = [];
  let done = 0;
  for (const { path, file } of found) {
    loading.value = { what: path, share: done / total };
    files.push({ path, bytes: new Uint8Array(await file.arrayBuffer()) });
    done += file.size;
  }
  return files;
}

/** Of a file chooser; a chosen folder's files have paths below it. */
export function readChosen(list: FileList): Promise<EngineFile[]> {
  return bytesOf([...list].map((file) => ({ path: file.webkitRelativePath || file.name, file })));
}

/** Of a drop or a paste: files and whole folders. */
export async function readTransfer(transfer: DataTransfer): Promise<EngineFile[]> {
  const items = [...transfer.items].filter((item) => item.kind === "file");
  // All at once: the transfer is empty after the first wait.
  const entries = items.map((item) => item.webkitGetAsEntry?.() ?? null);
  const plain = items.map((item) => item.getAsFile());
  const found: Found[] = [];
  for (let i = 0; i < items.length; i++) {
    const entry = entries[i];
    const file = plain[i];
    if (entry?.isDirectory || (entry && !file)) {
      await walk(entry, found);
    } else if (file) {
      found.push({ path: file.name, file });
    }
  }
  return bytesOf(found);
}
