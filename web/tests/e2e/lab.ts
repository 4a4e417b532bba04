// What all tests in the browser begin with: Debian's Chromium, the built page on a host of its own, and a record of what must not happen:
// errors in the console, requests to any other host.
import { existsSync } from "node:fs";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";
import { afterAll, beforeAll, expect } from "vitest";
import { kDist, serve, type StaticHost } from "./server";

const kChromium = process.env["CHROMIUM"] ?? "/usr/bin/chromium";

/** Neither a sandbox (tests run as root in containers) nor anything that talks to the network by itself. */
const kFlags = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
];

export interface LabOptions extends Pick<BrowserContextOptions, "locale" | "viewport" | "colorScheme" | "reducedMotion" | "hasTouch"> {
  /** with the headers that allow shared memory (default) */
  isolated?: boolean;
  /** the page's path on its host; it must work below any */
  path?: string;
  /** behind the `#` of the address */
  hash?: string;
  /** of a server that runs already, instead of a host of the tests' own */
  url?: string;
  /** what the browser shall lack, before the page begins */
  prepare?: (page: Page) => Promise<unknown>;
  /** false: for pages that never have a picture */
  waits?: boolean;
}

export interface Lab {
  page: Page;
  /** what must not happen, as it happens */
  problems: string[];
  /** ends the page, and fails where there were problems */
  close: () => Promise<void>;
}

let browser: Browser | undefined;

/** Call it at the top of a file of tests: one browser for all of them. */
export function useBrowser(): void {
  beforeAll(async () => {
    if (!existsSync(`${kDist}index.html`)) {
      throw new Error("web/dist is not built: scripts/lab --build-only");
    }
    browser = await chromium.launch({ executablePath: kChromium, args: kFlags });
  });
  afterAll(async () => {
    await browser?.close();
    browser = undefined;
  });
}

function watch(page: Page, host: StaticHost): string[] {
  const problems: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") {
      problems.push(`console: ${message.text()} (${message.location().url})`);
    }
  });
  page.on("pageerror", (error) => problems.push(`uncaught: ${error.stack ?? error.message}`));
  page.on("requestfailed", (request) => problems.push(`failed: ${request.url()} ${request.failure()?.errorText ?? ""}`));
  page.context().on("request", (request) => {
    const url = new URL(request.url());
    if (!["blob:", "data:"].includes(url.protocol) && url.origin !== new URL(host.url).origin) {
      problems.push(`another host: ${request.url()}`);
    }
  });
  return problems;
}

/** The page, opened, its engine ready and its first full picture drawn. */
export async function openLab(options: LabOptions = {}): Promise<Lab> {
  const { isolated = true, path = "/", hash = "", url, prepare, waits = true, ...context } = options;
  const host = url === undefined ? await serve({ isolated, path }) : { url, close: () => Promise.resolve() };
  const session = await browser!.newContext({ locale: "en-GB", viewport: { width: 1280, height: 800 }, ...context });
  const page = await session.newPage();
  const problems = watch(page, host);
  await prepare?.(page);
  await page.goto(`${host.url}${hash}`);
  if (waits) {
    await settled(page);
  }
  return {
    page,
    problems,
    close: async () => {
      await session.close();
      await host.close();
      expect(problems).toEqual([]);
    },
  };
}

/** Until the picture is the full one of the scene as it is now, as large as the stage has room for. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(
    () => {
      const picture = document.querySelector<HTMLCanvasElement>('[data-testid="picture"]');
      const frame = document.querySelector<HTMLElement>('[data-testid="stage"]');
      const room = frame?.parentElement;
      if (!picture || !frame || !room || picture.dataset["final"] !== "true") {
        return false;
      }
      const ratio = window.devicePixelRatio;
      const fills = Math.abs(frame.offsetWidth - room.clientWidth) <= 1 || Math.abs(frame.offsetHeight - room.clientHeight) <= 1;
      const fits = frame.offsetWidth <= room.clientWidth + 1 && frame.offsetHeight <= room.clientHeight + 1;
      return fills && fits && Math.abs(picture.width - frame.offsetWidth * ratio) <= 1;
    },
    undefined,
    { timeout: 30_000 },
  );
}
