// Files given to the page as people give them: dropped together, or chosen with the button.
import type { Page } from "playwright-core";
import type { TestFile } from "../fixtures/models";
import { settled } from "./lab";
import "./window";

/** Drops File objects onto the stage: enter, over, drop, as a browser tells them. */
export async function drop(page: Page, files: readonly TestFile[]): Promise<void> {
  const list = files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString("base64") }));
  const transfer = await page.evaluateHandle((items) => {
    const data = new DataTransfer();
    for (const { name, base64 } of items) {
      data.items.add(new File([Uint8Array.from(atob(base64), (char) => char.charCodeAt(0))], name));
    }
    return data;
  }, list);
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.getByTestId("stage").dispatchEvent(type, { dataTransfer: transfer });
  }
  await transfer.dispose();
}

/** Drops what lies on disk through the browser itself, folders too. */
export async function dropFromDisk(page: Page, paths: readonly string[]): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files: [...paths], dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"] as const) {
    await session.send("Input.dispatchDragEvent", { type, x: 300, y: 300, data });
  }
  await session.detach();
}

/** Does something that opens a scene, and waits for its full picture. */
export async function opened(page: Page, act: () => Promise<unknown>): Promise<void> {
  const before = await page.evaluateHandle(() => window.lustro.scene.value);
  await act();
  await page.waitForFunction((scene) => window.lustro.scene.value !== scene, before, { timeout: 30_000 });
  await settled(page);
  await before.dispose();
}

/** What the messages of a kind say. */
export async function said(page: Page, kind: "error" | "warning" | "note" | "success"): Promise<string> {
  return (await page.getByTestId(`message-${kind}`).allInnerTexts()).join("\n");
}

/** The hash of the page's scene as its engine draws it in this size. */
export async function hashOf(page: Page, samples = 0): Promise<string | undefined> {
  return page.evaluate(
    async (size) => {
      const { engine, scene } = window.lustro;
      return (await engine.value!.render({ scene: scene.value, ...size, hash: true }, true)).hash;
    },
    { width: 200, height: 150, samples },
  );
}
