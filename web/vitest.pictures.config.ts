// The pictures of the documentation (tests/pictures): drawn by hand, `npm run pictures`, and no part of the tests.
import { defineConfig } from "vitest/config";

export default defineConfig({
  test: { include: ["tests/pictures/**/*.ts"], fileParallelism: false, testTimeout: 120_000, hookTimeout: 30_000 },
});
