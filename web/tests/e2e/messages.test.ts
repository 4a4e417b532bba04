// What a browser or a web host may lack is said in the page, in the reader's language, and the rest goes on where it can.
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { said } from "./drop";
import { openLab, useBrowser, type Lab } from "./lab";
import "./window";

useBrowser();

/** No engine: the stage says so, the message says why, and the page itself works. */
async function expectNoEngine(lab: Lab, why: RegExp): Promise<void> {
  const { page } = lab;
  await page.getByTestId("engine-failed").waitFor();
  expect(await said(page, "error")).toMatch(why);
  expect(await page.getByTestId("engine-starting").count()).toBe(0);
  await page.getByTestId("examples").click();
  await page.getByTestId("examples-dialog-close").click();
}

/** The page without one of the browser's own things. */
const without = (name: string) => (page: Page) => page.addInitScript((key) => Reflect.deleteProperty(globalThis, key), name);

test("without WebGL2 the engine's picture is there, and the comparison says why it is not", async () => {
  const prepare = (page: Page) =>
    page.addInitScript(() => {
      const getContext = HTMLCanvasElement.prototype.getContext;
      Object.assign(HTMLCanvasElement.prototype, {
        getContext(this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
          return kind.startsWith("webgl") ? null : Reflect.apply(getContext, this, [kind, ...rest]);
        },
      });
    });
  const { page, close } = await openLab({ prepare, locale: "it-IT" });
  expect(await page.evaluate(() => window.lustro.picture.value!.pixelsCovered)).toBeGreaterThan(1000);
  expect(await said(page, "error")).toBe("");
  await page.getByTestId("compare").click();
  await page.getByTestId("compare-gpu").click();
  await expect.poll(() => said(page, "error")).toContain("Questo browser non ha WebGL2");
  expect(await page.getByTestId("compare-none").getAttribute("aria-pressed"), "one picture again").toBe("true");
  await page.getByTestId("compare-settings").click();
  await page.getByTestId("compare-right").waitFor();
  await close();
});

test("without WebAssembly", async () => {
  const lab = await openLab({ prepare: without("WebAssembly"), waits: false });
  await expectNoEngine(lab, /WebAssembly/);
  await lab.close();
});

test("without workers", async () => {
  const lab = await openLab({ prepare: without("Worker"), waits: false });
  await expectNoEngine(lab, /no workers/);
  await lab.close();
});

test("a worker whose program is not on the web host", async () => {
  const lab = await openLab({ prepare: (page) => page.route(/worker-.*\.js$/, (route) => route.fulfill({ status: 404 })), waits: false });
  await expectNoEngine(lab, /worker did not start/);
  expect(lab.problems.splice(0).join("\n")).toContain("worker-");
  await lab.close();
});

test("an engine that is not on the web host, then a reload where it is", async () => {
  const lab = await openLab({
    prepare: (page) => page.route("**/*.wasm", (route) => route.fulfill({ status: 404 }), { times: 1 }),
    waits: false,
  });
  await expectNoEngine(lab, /lustro.*\.wasm.*404/);
  expect(lab.problems.splice(0).join("\n")).toContain("404");
  await lab.page.reload();
  await lab.page.waitForSelector('[data-testid="picture"][data-final="true"]');
  expect(await said(lab.page, "error")).toBe("");
  await lab.close();
});

test("an engine that is damaged", async () => {
  const body = Buffer.from("this is no program");
  const lab = await openLab({
    prepare: (page) => page.route("**/*.wasm", (route) => route.fulfill({ contentType: "application/wasm", body })),
    waits: false,
  });
  await expectNoEngine(lab, /WebAssembly/);
  await lab.close();
});

test("without shared memory all workers draw, and one that is alone says why", async () => {
  const prepare = (page: Page) =>
    page.addInitScript(() => {
      Reflect.deleteProperty(globalThis, "SharedArrayBuffer");
      Object.defineProperty(navigator, "hardwareConcurrency", { value: 3 });
      // The first worker starts, no other does.
      const Before = Worker;
      let count = 0;
      window.Worker = class extends Before {
        constructor(url: string | URL, options?: WorkerOptions) {
          if (count++ > 0 && location.hash === "") {
            throw new Error("no more workers");
          }
          super(url, options);
        }
      };
    });
  const lab = await openLab({ prepare, isolated: false });
  const facts = lab.page.getByTestId("facts");
  await lab.page.getByTestId("tab-scene").click();
  await expect.poll(() => facts.textContent()).toContain("the browser started no further workers");
  expect(await lab.page.evaluate(() => window.lustro.engine.value!.info.threads)).toBe(1);
  await lab.close();

  const all = await openLab({ prepare, isolated: false, hash: "#all" });
  expect(await all.page.evaluate(() => [crossOriginIsolated, typeof SharedArrayBuffer])).toEqual([false, "undefined"]);
  await all.page.getByTestId("tab-scene").click();
  await expect.poll(() => all.page.getByTestId("facts").textContent()).toContain("3 workers");
  await all.close();
});
