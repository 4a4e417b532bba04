// Hands on the view: the camera and the lights' handles by mouse, wheel, touch and keyboard; each gesture is one step of undo, and is drawn
// small while it lasts.
import type { CDPSession, Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, describe, expect, test } from "vitest";
import type { SceneDoc, Vec3, ViewInfo } from "../../src/engine/types";
import { worldToPixel } from "../../src/stage/projection";
import { length, subtract } from "../../src/stage/vector";
import { openBench } from "./bench-page";
import { openLab, settled, useBrowser, type Lab } from "./lab";
import { pictureMark, sceneNow, stated, type Desk } from "./operate";
import "./window";

useBrowser();

const kScene: SceneDoc = {
  image: { samples: 4 },
  camera: { eye: [0, 1, 9], target: [0, 0.5, 0] },
  lights: [
    { type: "point", position: [2, 2.5, 2], diffuse: [0.6, 0.5, 0.4] },
    { type: "directional", direction: [0.5, -0.6, -0.4], diffuse: [0.3, 0.3, 0.4] },
    { type: "spot", position: [-2.5, 2.5, 1.5], direction: [0.7, -0.6, -0.3], cutoff: 25, diffuse: [0.8, 0.8, 0.8] },
  ],
  objects: [{ mesh: "primitive:teapot", material: "brass" }],
};

/** So many lights that no machine draws a full picture of them within a frame. */
const kManyLights: SceneDoc = {
  ...kScene,
  lights: Array.from({ length: 400 }, (_, i) => ({
    type: "point",
    position: [4 * Math.cos(i), 3, 4 * Math.sin(i)],
    diffuse: [0.005, 0.005, 0.005],
    specular: [0.005, 0.005, 0.005],
  })),
};

interface Place {
  x: number;
  y: number;
}

let lab: Lab;
let page: Page;
let touch: CDPSession;
let desk: Desk;
beforeAll(async () => {
  lab = await openLab({ viewport: { width: 1000, height: 600 }, hasTouch: true });
  page = lab.page;
  page.setDefaultTimeout(10_000);
  touch = await page.context().newCDPSession(page);
});
afterAll(() => lab.close());
beforeEach(async () => {
  desk = await openBench(page, { tab: "lights", scene: kScene });
});

/** A place of the view, 0..1, on the page. */
async function onStage(x: number, y: number): Promise<Place> {
  const box = (await page.getByTestId("stage").boundingBox())!;
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

async function dragMouse(from: Place, to: Place, button: "left" | "right" | "middle" = "left"): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down({ button });
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up({ button });
}

/** Fingers that go from one place to another, all at once. */
async function dragFingers(...ways: readonly (readonly [from: Place, to: Place])[]): Promise<void> {
  const at = (share: number) =>
    ways.map(([from, to], id) => ({ x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y), id }));
  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0) });
  for (let step = 1; step <= 5; ++step) {
    await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(step / 5) });
  }
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}

async function view(): Promise<ViewInfo> {
  await settled(page);
  return page.evaluate(() => window.lustro.picture.value!.view);
}

const distance = (v: ViewInfo): number => length(subtract(v.eye, v.target));

/** How the camera went, measured in the pictures before and after. */
async function moved(gesture: () => Promise<unknown>): Promise<{ before: ViewInfo; after: ViewInfo; turned: boolean; panned: boolean }> {
  const before = await view();
  const [mark, doc] = [await pictureMark(page), await sceneNow(page)];
  await gesture();
  await expect.poll(() => sceneNow(page)).not.toEqual(doc);
  expect(await pictureMark(page)).not.toBe(mark);
  const after = await view();
  return {
    before,
    after,
    turned: length(subtract(before.forward, after.forward)) > 0.01,
    panned: length(subtract(before.target, after.target)) > 0.01,
  };
}

describe("the camera", () => {
  test("while it turns the pictures are small, at rest comes the full one; it is one step of undo", async () => {
    desk = await openBench(page, { tab: "camera", scene: kManyLights });
    await page.evaluate(() => {
      const sizes: number[] = [];
      Object.assign(window, { sizes });
      (window.lustro.picture as unknown as { subscribe: (f: () => void) => void }).subscribe(() =>
        sizes.push(window.lustro.picture.value!.width),
      );
    });
    // The page has learned from an earlier gesture what a picture costs.
    await dragMouse(await onStage(0.3, 0.5), await onStage(0.6, 0.5));
    await settled(page);
    await page.getByTestId("undo").click();
    const full = (await view()).width;
    const sizes = () => page.evaluate(() => (window as unknown as { sizes: number[] }).sizes);
    const start = (await sizes()).length;
    const from = await onStage(0.3, 0.5);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 60, from.y, { steps: 3 });
    await expect.poll(async () => (await sizes()).length).toBeGreaterThan(start);
    expect(await page.getByTestId("picture").getAttribute("data-final"), "held, it is not final").toBe("false");
    await page.mouse.move(from.x + 120, from.y + 20, { steps: 3 });
    await page.mouse.up();
    await settled(page);
    const drawn = (await sizes()).slice(start);
    expect(drawn[0], "the first one is small").toBeLessThan(full);
    expect(drawn.at(-1), "the last one is not").toBe(full);

    const turned = await sceneNow(page);
    await page.getByTestId("undo").click();
    expect(await sceneNow(page)).toEqual(desk.base.scene);
    expect(await page.getByTestId("undo").isDisabled()).toBe(true);
    expect(await pictureMark(page)).toBe(desk.base.picture);
    await page.getByTestId("redo").click();
    expect(await sceneNow(page)).toEqual(turned);
  });

  test("by the mouse: turns, moves, zooms at the pointer, looks at what is clicked twice", async () => {
    const [middle, side] = [await onStage(0.4, 0.5), await onStage(0.5, 0.55)];
    const orbit = await moved(() => dragMouse(middle, side));
    expect([orbit.turned, orbit.panned]).toEqual([true, false]);
    expect(distance(orbit.after)).toBeCloseTo(distance(orbit.before), 3);
    expect(orbit.after.right[1], "the horizon stays level").toBeCloseTo(0, 4);

    for (const button of ["right", "middle"] as const) {
      const pan = await moved(() => dragMouse(middle, side, button));
      expect([pan.turned, pan.panned], button).toEqual([false, true]);
    }
    await page.keyboard.down("Shift");
    const pan = await moved(() => dragMouse(middle, side));
    await page.keyboard.up("Shift");
    expect([pan.turned, pan.panned], "with shift").toEqual([false, true]);

    const corner = await onStage(0.2, 0.3);
    await page.mouse.move(corner.x, corner.y);
    const zoom = await moved(() => page.mouse.wheel(0, -200));
    expect(distance(zoom.after)).toBeLessThan(0.9 * distance(zoom.before));
    expect([zoom.turned, zoom.panned], "towards the pointer").toEqual([false, true]);
    expect(distance((await moved(() => page.mouse.wheel(0, 300))).after)).toBeGreaterThan(distance(zoom.after));

    await page.keyboard.press("Escape");
    await page.getByTestId("tab-camera").click();
    await page.getByTestId("view-front").click();
    const spot = await onStage(0.45, 0.52);
    const aim = await moved(() => page.mouse.dblclick(spot.x, spot.y));
    expect([aim.turned, aim.panned]).toEqual([false, true]);
  });

  test("by touch: one finger turns, two move and pinch", async () => {
    const [a, b, c] = [await onStage(0.4, 0.5), await onStage(0.5, 0.55), await onStage(0.6, 0.5)];
    const orbit = await moved(() => dragFingers([a, b]));
    expect([orbit.turned, orbit.panned]).toEqual([true, false]);
    const down = (place: Place) => ({ x: place.x, y: place.y + 60 });
    const pan = await moved(() => dragFingers([a, down(a)], [c, down(c)]));
    expect([pan.turned, pan.panned]).toEqual([false, true]);
    expect(distance(pan.after)).toBeCloseTo(distance(pan.before), 1);
    const pinch = await moved(() => dragFingers([a, { x: a.x - 60, y: a.y }], [c, { x: c.x + 60, y: c.y }]));
    expect(pinch.turned).toBe(false);
    expect(distance(pinch.after), "fingers that part come nearer").toBeLessThan(0.8 * distance(pinch.before));
    expect(await page.evaluate(() => scrollX + scrollY + (visualViewport?.scale ?? 1)), "the page itself stays").toBe(1);
  });

  test("by keys: turns, moves, zooms, frames, its views and its projection", async () => {
    const stage = page.getByTestId("stage");
    for (const key of ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"]) {
      const orbit = await moved(() => stage.press(key));
      expect([orbit.turned, orbit.panned], key).toEqual([true, false]);
      const pan = await moved(() => stage.press(`Shift+${key}`));
      expect([pan.turned, pan.panned], `shift and ${key}`).toEqual([false, true]);
    }
    const near = await moved(() => stage.press("+"));
    expect(distance(near.after)).toBeLessThan(distance(near.before));
    const far = await moved(() => stage.press("-"));
    expect(distance(far.after)).toBeCloseTo(distance(near.before), 3);

    const views: [string, Vec3][] = [
      ["1", [0, 0, -1]],
      ["Shift+1", [0, 0, 1]],
      ["3", [-1, 0, 0]],
      ["Shift+3", [1, 0, 0]],
      ["7", [0, -1, 0]],
      ["Shift+7", [0, 1, 0]],
    ];
    for (const [key, forward] of views) {
      const { after } = await moved(() => stage.press(key.replace(/\d/, "Digit$&")));
      expect(length(subtract(after.forward, forward)), key).toBeLessThan(0.01);
    }
    const home = await moved(() => stage.press("Home"));
    expect(await stated(page, "camera.view")).toBe("three-quarter");
    expect(home.turned).toBe(true);

    await moved(() => stage.press("5"));
    expect(await stated(page, "camera.projection")).toBe("orthographic");
    await moved(() => stage.press("5"));
    expect(await stated(page, "camera.projection")).toBe("perspective");

    await moved(() => stage.press("Shift+ArrowLeft"));
    const framed = await moved(() => stage.press("f"));
    expect([framed.turned, framed.panned]).toEqual([false, true]);
    await moved(() => stage.press("+"));
    await moved(() => page.getByTestId("frame").click());
  });
});

describe("the lights' handles", () => {
  const handle = (index: number, kind = "handle") => page.getByTestId(`light-${kind}-${index}`);

  async function placeOf(index: number, kind = "handle"): Promise<Place> {
    await settled(page);
    const box = (await handle(index, kind).locator(".grip").boundingBox())!;
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  const by = ({ x, y }: Place, dx: number, dy: number): Place => ({ x: x + dx, y: y + dy });

  async function isAt(index: number, place: Place, kind = "handle"): Promise<void> {
    const there = await placeOf(index, kind);
    expect(Math.hypot(there.x - place.x, there.y - place.y), "the handle is where it was dragged").toBeLessThan(2.5);
  }

  for (const [how, drag] of [
    ["the mouse", dragMouse],
    ["touch", (from: Place, to: Place) => dragFingers([from, to])],
  ] as const) {
    test(`by ${how}: a light is moved, turned and aimed`, async () => {
      const camera = desk.base.scene.camera;
      const v = await view();
      const depth = async () => worldToPixel(v, (await stated(page, "lights[0].position")) as Vec3)!.depth;
      const before = await depth();
      const point = await placeOf(0);
      await drag(point, by(point, -70, 30));
      expect(await stated(page, "lights[0].position")).not.toEqual([2, 2.5, 2]);
      expect(await depth(), "it moves along the screen").toBeCloseTo(before, 2);
      await isAt(0, by(point, -70, 30));
      expect(await pictureMark(page)).not.toBe(desk.base.picture);
      expect(await page.getByTestId("light-0").getAttribute("aria-pressed"), "it is chosen").toBe("true");

      const sun = await placeOf(1);
      await drag(sun, by(sun, 60, 20));
      expect(await stated(page, "lights[1].direction")).not.toEqual(kScene.lights![1]!["direction"]);

      const spot = await placeOf(2);
      await drag(spot, by(spot, 40, 10));
      const position = await stated(page, "lights[2].position");
      expect(position).not.toEqual(kScene.lights![2]!["position"]);
      const aim = await placeOf(2, "aim");
      await drag(aim, by(aim, 50, 20));
      expect(await stated(page, "lights[2].position"), "aiming leaves it where it is").toEqual(position);
      expect(await stated(page, "lights[2].direction")).not.toEqual(kScene.lights![2]!["direction"]);
      expect(await stated(page, "camera"), "the camera stays").toEqual(camera);

      // Four gestures, four steps.
      for (let step = 0; step < 4; ++step) {
        await page.getByTestId("stage").press("Control+z");
      }
      expect(await sceneNow(page)).toEqual(desk.base.scene);
      expect(await page.getByTestId("undo").isDisabled()).toBe(true);
      expect(await pictureMark(page)).toBe(desk.base.picture);
    });
  }

  test("by keys: chosen, moved in large and small steps, aimed; undone and done again", async () => {
    const point = await placeOf(0);
    await handle(0).press("Enter");
    expect(await page.getByTestId("light-0").getAttribute("aria-pressed")).toBe("true");
    await handle(0).press("ArrowLeft");
    await isAt(0, by(point, -8, 0));
    await handle(0).press("Shift+ArrowDown");
    await isAt(0, by(point, -8, 1));
    await handle(0).press("ArrowRight");
    await handle(0).press("ArrowUp");
    await isAt(0, by(point, 0, -7));
    const there = await stated(page, "lights[0].position");
    expect(await pictureMark(page)).not.toBe(desk.base.picture);

    await page.getByTestId("light-2").click();
    await handle(2, "aim").press("ArrowRight");
    expect(await stated(page, "lights[2].direction")).not.toEqual(kScene.lights![2]!["direction"]);
    expect(await stated(page, "lights[2].position")).toEqual(kScene.lights![2]!["position"]);

    await handle(2, "aim").press("Control+z");
    expect(await stated(page, "lights[2].direction")).toEqual(kScene.lights![2]!["direction"]);
    await page.getByTestId("stage").press("Control+Shift+z");
    expect(await stated(page, "lights[2].direction")).not.toEqual(kScene.lights![2]!["direction"]);
    await page.getByTestId("stage").press("Control+z");
    await page.getByTestId("stage").press("Control+y");
    expect(await stated(page, "lights[2].direction")).not.toEqual(kScene.lights![2]!["direction"]);
    expect(await stated(page, "lights[0].position")).toEqual(there);
  });

  test("none hides below the tools of the picture", async () => {
    const tools = (await page.locator(".stage-tools").boundingBox())!;
    const sun = await placeOf(1);
    expect(sun.x, "it stands where the tools are").toBeLessThan(tools.x + tools.width);
    expect(sun.y, "but below them").toBeGreaterThan(tools.y + tools.height);
  });

  test("there are none while something else is worked on", async () => {
    expect(await page.locator("[data-handle]").count()).toBe(3);
    await page.getByTestId("tab-shading").click();
    expect(await page.locator("[data-handle]").count()).toBe(0);
  });
});
