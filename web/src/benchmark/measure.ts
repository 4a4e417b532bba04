// Times of the page on this machine: the engine on one worker and on all, a drag, WebGL2 by the engine's shaders, and three.js showing the same.
// Answers are checked before they are timed.
import type { Engine, GpuScene, RenderRequest, StageTimes } from "../engine/types";
import { createEngine } from "../engine/client";
import { differenceOf, straight } from "../gpu/difference";
import { GpuView } from "../gpu/gpu-view";
import { Pace } from "../stage/pace";
import { kRequest } from "./scene";

export interface Times {
  median: number;
  least: number;
  runs: number;
}

export interface Report {
  triangles: number;
  /** milliseconds a picture, calls included */
  engineOneWorker: Times;
  /** the engine's own clock, one worker: the median of each stage */
  engineStages: StageTimes;
  engineAllWorkers: Times;
  workers: number;
  /** pictures a second while the camera turns, at the size that the page chooses then */
  dragRate: number;
  dragWidth: number;
  /** absent where there is no WebGL2; milliseconds a picture until the card has drawn it */
  webgl?: Times;
  three?: Times;
  /** share of the pixels in which WebGL2 and the engine differ by more than 2/255 */
  webglDiffers?: number;
}

function timesOf(list: number[]): Times {
  const sorted = [...list].sort((a, b) => a - b);
  return { median: sorted[sorted.length >> 1] ?? NaN, least: sorted[0] ?? NaN, runs: sorted.length };
}

/** Runs until so much time is over, but a few times at least. */
async function repeated(milliseconds: number, run: () => Promise<void> | void): Promise<Times> {
  for (let warm = 0; warm < 5; ++warm) {
    await run();
  }
  const list: number[] = [];
  for (const end = performance.now() + milliseconds; list.length < 9 || performance.now() < end;) {
    const begin = performance.now();
    await run();
    list.push(performance.now() - begin);
  }
  return timesOf(list);
}

/** The request with the camera turned about the vertical. */
function turned(request: RenderRequest, angle: number): RenderRequest {
  const eye = [2.2 * Math.sin(angle), 1.5, 2.2 * Math.cos(angle)];
  return { ...request, scene: { ...request.scene, camera: { ...request.scene.camera, eye } } };
}

async function engineTimes(engine: Engine, milliseconds: number): Promise<{ times: Times; stages: StageTimes }> {
  let angle = 0;
  const stages: StageTimes[] = [];
  const times = await repeated(milliseconds, async () => {
    stages.push((await engine.render(turned(kRequest, (angle += 0.01)), true)).times);
  });
  const medianOf = (name: keyof StageTimes) => timesOf(stages.map((stage) => stage[name])).median;
  return {
    times,
    stages: {
      prepare: medianOf("prepare"),
      shadows: medianOf("shadows"),
      cull: medianOf("cull"),
      visibility: medianOf("visibility"),
      shading: medianOf("shading"),
      total: medianOf("total"),
    },
  };
}

/** As stage/render-loop.ts draws while the camera is dragged: the size follows the time. */
async function drag(engine: Engine, milliseconds: number): Promise<{ rate: number; width: number }> {
  const pace = new Pace();
  let pictures = 0;
  let width = 0;
  let angle = 0;
  const begin = performance.now();
  while (performance.now() - begin < milliseconds) {
    const scale = pace.scaleFor(kRequest.width * kRequest.height);
    const small = {
      ...turned(kRequest, (angle += 0.01)),
      width: Math.round(kRequest.width * scale),
      height: Math.round(kRequest.height * scale),
    };
    const picture = await engine.render(small, true);
    pace.learnQuick(picture.width * picture.height, picture.milliseconds);
    width = picture.width;
    ++pictures;
    await new Promise((resolve) => requestAnimationFrame(resolve));
  }
  return { rate: (pictures * 1000) / (performance.now() - begin), width };
}

function canvasOf(scene: GpuScene): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = scene.width;
  canvas.height = scene.height;
  return canvas;
}

export async function measure(milliseconds: number, say: (what: string) => void): Promise<Report> {
  say("one worker");
  const single = await createEngine({ threads: 1 });
  const picture = await single.render(kRequest, true);
  const oneWorker = await engineTimes(single, milliseconds);
  say("all workers");
  const engine = await createEngine();
  await engine.complete();
  const allWorkers = await engineTimes(engine, milliseconds);
  say("a drag");
  const { rate, width } = await drag(engine, milliseconds);
  const report: Report = {
    triangles: picture.triangles,
    engineOneWorker: oneWorker.times,
    engineStages: oneWorker.stages,
    engineAllWorkers: allWorkers.times,
    workers: engine.info.threads,
    dragRate: rate,
    dragWidth: width,
  };
  say("WebGL2");
  const scene = await single.gpuScene(kRequest);
  const view = GpuView.create(canvasOf(scene));
  if (view) {
    const geometry = await single.gpuGeometry(scene.instances[0]!.geometry);
    await view.prepare(scene, () => Promise.resolve(geometry));
    view.draw(scene);
    report.webglDiffers = differenceOf(picture.bytes, straight(view.read()), 1).shareOver;
    say("three.js");
    const { ThreeView } = await import("./three-view");
    const three = new ThreeView(canvasOf(scene), geometry);
    three.draw();
    if (three.coveredShare() < 0.1) {
      throw new Error("three.js draws nothing that could be compared");
    }
    // In turns, so that both see the same machine.
    const ours: number[] = [];
    const theirs: number[] = [];
    for (let round = 0; round < 9; ++round) {
      ours.push((await repeated(milliseconds / 9, () => (view.draw(scene), view.finish()))).median);
      theirs.push((await repeated(milliseconds / 9, () => (three.draw(), three.finish()))).median);
    }
    report.webgl = timesOf(ours);
    report.three = timesOf(theirs);
    view.dispose();
    three.dispose();
  }
  return report;
}
