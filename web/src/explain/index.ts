// Explain's places on the page: the panel, the reader under the pointer, what is drawn over the picture.
import { register } from "../state/slots";
import { startAsking } from "./ask";
import { lazily } from "./lazy";
import { VectorOverlay } from "./overlay";
import { LineButton, LineOverlay } from "./line-tool";
import { Reader } from "./reader";
import "../plots/plots.css";
import "./explain.css";

startAsking();
register("explain", { id: "equation", order: 10, component: lazily(() => import("./panel")) });
register("layer", { id: "reader", order: 50, component: Reader });
register("overlay", { id: "vectors", order: 60, component: VectorOverlay });
register("overlay", { id: "profile", order: 70, component: LineOverlay });
register("stageTool", { id: "line", order: 60, component: LineButton });
