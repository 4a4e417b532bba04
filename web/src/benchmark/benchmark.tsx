// The page's benchmark mode (`?benchmark`, or `?benchmark=2000` for milliseconds a measurement): a table instead of the lab.
import { signal } from "@preact/signals";
import { render } from "preact";
import type { StageTimes } from "../engine/types";
import { errorText } from "../state/messages";
import { measure, type Report, type Times } from "./measure";
import "./benchmark.css";

declare global {
  interface Window {
    /** for scripts: the report, or why there is none */
    lustroBenchmark?: Report | { error: string };
  }
}

const step = signal("");
const report = signal<Report | undefined>(undefined);
const problem = signal("");

function Row({ name, times, note }: { name: string; times: Times | undefined; note?: string }) {
  return (
    <tr>
      <th scope="row">{name}</th>
      <td>{times ? `${times.median.toFixed(2)} ms` : "–"}</td>
      <td>{times ? `${times.least.toFixed(2)} ms` : ""}</td>
      <td>{note ?? ""}</td>
    </tr>
  );
}

function ratioOf(a: Times | undefined, b: Times | undefined): string {
  return a && b ? `${(a.median / b.median).toFixed(2)} × three.js` : "";
}

function stagesOf({ prepare, cull, visibility, shading }: StageTimes): string {
  const stages = { prepare, cull, visibility, shading };
  return Object.entries(stages)
    .map(([name, time]) => `${name} ${time.toFixed(2)}`)
    .join(" + ");
}

function Benchmark() {
  const found = report.value;
  return (
    <main class="benchmark">
      <h1>Lustro · benchmark</h1>
      <p aria-live="polite">
        {problem.value !== ""
          ? problem.value
          : found
            ? `${found.triangles.toLocaleString("en")} triangles, 3 lights, 960 × 540`
            : `measuring ${step.value} …`}
      </p>
      {found && (
        <table>
          <thead>
            <tr>
              <th />
              <th>median</th>
              <th>least</th>
              <th />
            </tr>
          </thead>
          <tbody>
            <Row name="engine, one worker" times={found.engineOneWorker} note={stagesOf(found.engineStages)} />
            <Row name={`engine, ${found.workers} workers`} times={found.engineAllWorkers} />
            <Row name="WebGL2, Lustro's shaders" times={found.webgl} note={ratioOf(found.webgl, found.three)} />
            <Row name="WebGL2, three.js, MeshPhongMaterial" times={found.three} />
            <tr>
              <th scope="row">dragging</th>
              <td>{found.dragRate.toFixed(1)} / s</td>
              <td />
              <td>{`${found.dragWidth} pixels wide`}</td>
            </tr>
          </tbody>
        </table>
      )}
    </main>
  );
}

export async function startBenchmark(root: HTMLElement, milliseconds: number): Promise<void> {
  render(<Benchmark />, root);
  try {
    report.value = await measure(milliseconds, (what) => (step.value = what));
    window.lustroBenchmark = report.value;
  } catch (reason) {
    problem.value = errorText(reason);
    window.lustroBenchmark = { error: problem.value };
  }
}
