// Tests in the browser (tests/e2e): one file after the other, since each has a browser of its own.
import { defineConfig } from "vitest/config";

export default defineConfig({
  test: { include: ["tests/e2e/**/*.test.ts"], fileParallelism: false, testTimeout: 60_000, hookTimeout: 30_000 },
});
