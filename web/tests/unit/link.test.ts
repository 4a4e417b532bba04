import { deflateSync, strToU8 } from "fflate";
import { expect, test } from "vitest";
import { filesOf, linkHash, readLink } from "../../src/files/link";
import { kExamples } from "../../src/files/examples";

test("a link restores the scene, the lights that are fixed to the camera and the names of files", () => {
  const content = {
    scene: {
      objects: [{ mesh: "bücher/bunny.obj", material: { diffuse: [0.1, 0.2, 0.3] } }],
      lights: [{ type: "point" }],
      ambient: [1e-7, 0.30000001, 2],
    },
    attached: [0],
    files: ["bücher/bunny.obj"],
  };
  expect(readLink(linkHash(content))).toEqual(content);
});

test("every example survives a link", () => {
  for (const { scene } of kExamples) {
    expect(readLink(linkHash({ scene, attached: [], files: [] }))?.scene).toEqual(scene);
  }
});

test("links are made of letters that no address has to escape", () => {
  expect(linkHash({ scene: kExamples[2]!.scene, attached: [], files: [] })).toMatch(/^#s=[A-Za-z0-9_-]+$/);
});

test("another fragment is no link", () => {
  expect(readLink("")).toBeUndefined();
  expect(readLink("#top")).toBeUndefined();
});

test("damaged links are refused, not shown", () => {
  const good = linkHash({ scene: { objects: [{ mesh: "primitive:cube" }] }, attached: [], files: [] });
  const packed = (value: unknown) => `#s=${Buffer.from(deflateSync(strToU8(JSON.stringify(value)))).toString("base64url")}`;
  expect(() => readLink(good.slice(0, -6))).toThrow();
  expect(() => readLink("#s=!!!")).toThrow();
  expect(() => readLink(packed({ scene: { objects: "none" } }))).toThrow("no scene");
  expect(() => readLink(packed({ scene: { objects: [1] } }))).toThrow("no scene");
  expect(() => readLink(packed([]))).toThrow("no scene");
});

test("a small link that unpacks to very much is refused", () => {
  const bomb = `#s=${Buffer.from(deflateSync(new Uint8Array(64 << 20))).toString("base64url")}`;
  expect(bomb.length).toBeLessThan(200_000);
  expect(() => readLink(bomb)).toThrow("too much");
});

test("what else stands in a link is left out", () => {
  const odd = `#s=${Buffer.from(deflateSync(strToU8(JSON.stringify({ scene: { objects: [] }, attached: [1, -2, "x", 0.5], files: [3, "a.obj"] })))).toString("base64url")}`;
  expect(readLink(odd)).toEqual({ scene: { objects: [] }, attached: [1], files: ["a.obj"] });
});

test("the files of a scene are its meshes, textures and sky", () => {
  expect(
    filesOf({
      objects: [
        { mesh: "primitive:cube", material: { textures: { diffuse: "wood.png" } } },
        { mesh: "car.glb#nodes[3]" },
        { mesh: "car.glb#nodes[4]" },
      ],
      materials: {
        a: { textures: { normal: { file: "n.png" }, reflection: { shape: "cube", right: "px.png", left: { file: "nx.png" } } } },
        b: "gold",
      },
      environment: { file: "sky.exr" },
    }).sort(),
  ).toEqual(["car.glb", "n.png", "nx.png", "px.png", "sky.exr", "wood.png"]);
});
