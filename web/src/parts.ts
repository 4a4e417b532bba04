// What registers itself in the slots of the page (state/slots.ts). A folder that adds something to the page has one line here.
import "./files";
import "./layout/stage-tools";
import "./stage/light-handles";
import "./gpu";
import "./explain";
import "./tour";
