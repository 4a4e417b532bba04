// The lights: every control of the panels, used as a person does.
import { kBenches } from "./controls";
import { testBenches, useLab } from "./controls-suite";

const lab = useLab();
testBenches(lab, kBenches.lights);
