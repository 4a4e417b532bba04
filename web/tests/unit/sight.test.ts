import { deflateSync, strToU8 } from "fflate";
import { afterEach, describe, expect, test } from "vitest";
import { splitLayout } from "../../src/gpu/split";
import { linkHash, readLink } from "../../src/files/link";
import { chosenChannel, chosenLight, drawn, isProfileComparing, isProfileEncoded, kDrawn, profileLine } from "../../src/explain/state";
import { currentSight, readSight, showSight, type ExplainSight, type Sight } from "../../src/files/sight";
import { comparison, wipe } from "../../src/state/compare";
import { fullSize } from "../../src/state/picture";
import { resetScene } from "../../src/state/scene";
import { selectedObject, selectedPixel } from "../../src/state/selection";

const kCompared: Sight = {
  compare: { kind: "settings", left: [["shading.interpolation", "flat"]], right: [[["lights", 0, "type"], "point"]] },
  wipe: 0.25,
  isSideBySide: true,
};

const kLine = { from: { x: 0.25, y: 0.5 }, to: { x: 0.75, y: 0.125 } };
const kExplained: ExplainSight = {
  line: { from: { x: 0.25, y: 0.5 }, to: { x: 0.75, y: 0.125 }, aspect: 1.5 },
  isComparing: true,
  isEncoded: true,
  light: 2,
  channel: 1,
  hidden: ["L", "triangle"],
};

afterEach(() => {
  showSight({});
  fullSize.value = { width: 0, height: 0 };
});

describe("what is seen besides the scene", () => {
  test("nothing of it is nothing in a link", () => {
    expect(currentSight()).toEqual({});
    const content = { scene: { objects: [] }, attached: [], files: [] };
    expect(linkHash({ ...content, sight: currentSight() })).toBe(linkHash(content));
  });

  test("is shown and stated again, through a link", () => {
    resetScene({ objects: [{ mesh: "primitive:cube" }, { mesh: "primitive:torus" }] });
    fullSize.value = { width: 300, height: 200 };
    const sight: Sight = { ...kCompared, pixel: { x: 20, y: 30, width: 300, height: 200 }, object: 1, explain: kExplained };
    showSight(readLink(linkHash({ scene: { objects: [] }, attached: [], files: [], sight }))!.sight!);
    expect([comparison.value, wipe.value, splitLayout.value]).toEqual([sight.compare, 0.25, "side"]);
    expect(selectedPixel.value).toEqual({ x: 20, y: 30 });
    expect(selectedObject.value).toBe(1);
    expect(currentSight()).toEqual(sight);
    expect([profileLine.value, isProfileComparing.value, isProfileEncoded.value]).toEqual([kLine, true, true]);
    expect([chosenLight.value, chosenChannel.value, kDrawn.filter((name) => !drawn.value[name])]).toEqual([2, 1, ["L", "triangle"]]);
  });

  test("a link without it ends a comparison", () => {
    showSight({ ...kCompared, explain: kExplained });
    showSight({});
    expect(currentSight()).toEqual({});
    expect([comparison.value.kind, wipe.value, splitLayout.value]).toEqual(["none", 0.5, "wipe"]);
    expect([profileLine.value, chosenLight.value, chosenChannel.value]).toEqual([undefined, undefined, undefined]);
    expect(Object.values(drawn.value)).not.toContain(false);
  });

  test("a pixel waits for the stage, and is the same place in a picture of another size", () => {
    showSight({ pixel: { x: 150, y: 100, width: 300, height: 200 } });
    expect(selectedPixel.value).toBeUndefined();
    fullSize.value = { width: 800, height: 400 };
    expect(selectedPixel.value).toEqual({ x: 401, y: 201 });
  });

  test("a line waits for the stage, and lies on the same surface in a picture of another shape", () => {
    showSight({ explain: kExplained });
    expect(profileLine.value).toBeUndefined();
    fullSize.value = { width: 300, height: 400 };
    expect(profileLine.value).toEqual({ from: { x: 0, y: 0.5 }, to: { x: 1, y: 0.125 } });
    showSight({ explain: kExplained });
    fullSize.value = { width: 900, height: 300 };
    expect(profileLine.value).toEqual({ from: { x: 0.375, y: 0.5 }, to: { x: 0.625, y: 0.125 } });
  });

  test("a pixel that waits gives way to what is shown after it", async () => {
    showSight({ pixel: { x: 1, y: 1, width: 300, height: 200 } });
    showSight({});
    fullSize.value = { width: 300, height: 200 };
    await Promise.resolve();
    expect(selectedPixel.value).toBeUndefined();
  });
});

describe("a link's own words are not trusted", () => {
  test.each([
    { compare: { kind: "gpu", show: "other", gain: 8 } },
    { compare: { kind: "gpu", show: "wipe", gain: 7 } },
    { compare: { kind: "settings", left: [], right: [[3, "x"]] } },
    { compare: { kind: "settings", left: [[["a", 0.5], 1]], right: [] } },
    { compare: { kind: "settings", left: "flat", right: [] } },
    { wipe: 2 },
    { wipe: "0.5" },
    { isSideBySide: "yes" },
    { pixel: { x: 300, y: 0, width: 300, height: 200 } },
    { pixel: { x: 0.5, y: 0, width: 300, height: 200 } },
    { pixel: { x: 0, y: 0 } },
    { object: -1 },
    { explain: { line: { from: { x: 0, y: 0 }, to: { x: 2, y: 0 }, aspect: 1 } } },
    { explain: { line: { from: { x: 0, y: 0 }, to: { x: 1, y: 0 }, aspect: 0 } } },
    { explain: { line: { from: { x: 0, y: 0 } } } },
    { explain: { light: 0.5, channel: 3, hidden: ["all"], isEncoded: 1 } },
    { explain: [] },
    "all",
    null,
  ])("%j", (sight) => {
    expect(readSight(sight)).toEqual({});
    const packed = Buffer.from(deflateSync(strToU8(JSON.stringify({ scene: { objects: [] }, sight })))).toString("base64url");
    expect(readLink(`#s=${packed}`)).toEqual({ scene: { objects: [] }, attached: [], files: [] });
  });
});
