// Comparisons, put into their places on the page.
import { comparison } from "../state/compare";
import { register } from "../state/slots";
import { CompareTool } from "./compare-tool";
import { GpuLayer } from "./gpu-layer";
import { SettingsLayer } from "./settings-layer";
import "./compare.css";

function CompareLayer() {
  const { kind } = comparison.value;
  return kind === "gpu" ? <GpuLayer /> : kind === "settings" ? <SettingsLayer /> : null;
}

register("layer", { id: "compare", order: 10, component: CompareLayer });
register("stageTool", { id: "compare", order: 30, component: CompareTool });
