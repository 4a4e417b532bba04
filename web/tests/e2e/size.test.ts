// What the page needs, compressed as web hosts do it: it must stay small enough for a slow line. Without three.js, which the benchmark alone
// fetches.
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { expect, test } from "vitest";
import { kDist } from "./server";

const kMost = 2_000_000;

function filesBelow(folder: string): string[] {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? filesBelow(path) : [path];
  });
}

test("everything that the page needs is under 2 MB compressed", () => {
  const sizes = filesBelow(kDist)
    .filter((file) => !file.includes("three-view"))
    .map((file) => gzipSync(readFileSync(file), { level: 9 }).length);
  const all = sizes.reduce((sum, size) => sum + size, 0);
  expect(all).toBeGreaterThan(500_000); // the engine is among them
  expect(all).toBeLessThan(kMost);
});
