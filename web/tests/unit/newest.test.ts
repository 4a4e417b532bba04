import { expect, it } from "vitest";
import { newestOnly } from "../../src/state/newest";

it("does one thing at a time, and once more for all that was asked for meanwhile", async () => {
  const ends: (() => void)[] = [];
  const again = newestOnly(() => new Promise<void>((resolve) => ends.push(resolve)));
  const end = async () => {
    ends.at(-1)!();
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  again();
  expect(ends.length).toBe(1);
  again();
  again();
  expect(ends.length).toBe(1);
  await end();
  expect(ends.length).toBe(2);
  await end();
  expect(ends.length).toBe(2);
  again();
  expect(ends.length).toBe(3);
});
