// The page: header, stage, panels, messages, and what floats above them.
import { useEffect } from "preact/hooks";
import { useSignalEffect } from "@preact/signals";
import { Header } from "./layout/header";
import { Messages } from "./layout/messages";
import { Panel } from "./layout/panel";
import { Tooltip } from "./layout/tooltip";
import { Stage } from "./stage/stage";
import { listenForUndo } from "./layout/undo-keys";
import { followMeshes } from "./state/meshes";
import { isDark, language } from "./state/settings";
import { entriesOf } from "./state/slots";
import { words } from "./i18n";

export function App() {
  useSignalEffect(() => {
    document.documentElement.dataset["theme"] = isDark.value ? "dark" : "light";
    document.documentElement.lang = language.value;
    document.title = `${words.value.title} · ${words.value.tagline}`;
  });
  useEffect(followMeshes, []);
  useEffect(listenForUndo, []);
  return (
    <div class="page">
      <Header />
      <main class="work">
        <Stage />
        <Panel />
      </main>
      <Messages />
      <Tooltip />
      {entriesOf("floating").map(({ id, component: Component }) => (
        <Component key={id} />
      ))}
    </div>
  );
}
