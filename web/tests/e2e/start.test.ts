// The page starts wherever it is put: any path, with the headers that isolate it and without, any size, light and dark, and talks to nobody.
import { describe, expect, test } from "vitest";
import { openLab, useBrowser, type LabOptions } from "./lab";
import "./window";

useBrowser();

const kPlaces: [string, LabOptions][] = [
  ["isolated, at the root", {}],
  ["a plain host, deep in it", { isolated: false, path: "/some/deep/folder/" }],
  ["a phone, in the dark, in Italian", { viewport: { width: 360, height: 740 }, colorScheme: "dark", locale: "it-IT", hasTouch: true }],
];

describe("the page starts", () => {
  test.each(kPlaces)("%s", async (_, options) => {
    const lab = await openLab(options);
    const { page } = lab;
    const colors = await page.evaluate(() => {
      const { bytes } = window.lustro.picture.value!;
      return new Set(new Uint32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4)).size;
    });
    expect(colors, "the teapot is lit").toBeGreaterThan(100);
    expect(await page.evaluate(() => crossOriginIsolated)).toBe(options.isolated ?? true);
    expect(await page.evaluate(() => document.documentElement.lang)).toBe(options.locale?.slice(0, 2) ?? "en");
    expect(await page.evaluate(() => document.documentElement.dataset["theme"])).toBe(options.colorScheme ?? "light");
    expect(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing sticks out").toBe(true);
    expect(await page.getByTestId("message-error").count()).toBe(0);
    await lab.close();
  });
});

test("what must not happen is noticed", async () => {
  const lab = await openLab();
  await lab.page.evaluate(async () => {
    console.error("something is wrong");
    await fetch("http://127.0.0.1:1/elsewhere").catch(() => {});
  });
  await lab.page.evaluate(() =>
    setTimeout(() => {
      throw new Error("nobody caught this");
    }),
  );
  await expect.poll(() => lab.problems.join("\n")).toContain("nobody caught this");
  const said = lab.problems.splice(0).join("\n");
  expect(said).toContain("something is wrong");
  expect(said, "the page's policy forbids other hosts").toMatch(/Content Security Policy|another host/);
  await lab.close();
});
