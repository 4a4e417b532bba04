// The panels beside the stage, or in a sheet below it on small screens: tabs, and what belongs to each.
import type { ComponentType } from "preact";
import { useRef } from "preact/hooks";
import { words } from "../i18n";
import { CameraPanel } from "../controls/camera-panel";
import { LightPanel } from "../controls/light-panel";
import { MaterialPanel } from "../controls/material-panel";
import { ScenePanel } from "../controls/scene-panel";
import { ShadingPanel } from "../controls/shading-panel";
import { isSheetOpen, panelTab, type PanelTab } from "../state/settings";
import { ExplainPanel } from "./explain-panel";

const kTabs: { tab: PanelTab; component: ComponentType }[] = [
  { tab: "shading", component: ShadingPanel },
  { tab: "material", component: MaterialPanel },
  { tab: "lights", component: LightPanel },
  { tab: "camera", component: CameraPanel },
  { tab: "scene", component: ScenePanel },
  { tab: "explain", component: ExplainPanel },
];

export function Panel() {
  const t = words.value;
  const list = useRef<HTMLDivElement>(null);
  const chosen = kTabs.find(({ tab }) => tab === panelTab.value) ?? kTabs[0]!;
  const Content = chosen.component;
  const onKey = (event: KeyboardEvent) => {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step !== 0) {
      const next = kTabs[(kTabs.indexOf(chosen) + step + kTabs.length) % kTabs.length]!;
      panelTab.value = next.tab;
      list.current?.querySelector<HTMLElement>(`#tab-${next.tab}`)?.focus();
      event.preventDefault();
    }
  };
  return (
    <aside class="panel" data-open={isSheetOpen.value} aria-label={t.panel.label}>
      <button
        class="sheet-handle"
        type="button"
        aria-expanded={isSheetOpen.value}
        aria-label={isSheetOpen.value ? t.panel.close : t.panel.open}
        data-testid="sheet"
        onClick={() => (isSheetOpen.value = !isSheetOpen.value)}
      />
      <div class="tabs" role="tablist" ref={list} onKeyDown={onKey}>
        {kTabs.map(({ tab }) => (
          <button
            key={tab}
            id={`tab-${tab}`}
            class="tab"
            type="button"
            role="tab"
            aria-selected={tab === chosen.tab}
            aria-controls="panel-content"
            tabIndex={tab === chosen.tab ? 0 : -1}
            data-testid={`tab-${tab}`}
            onClick={() => {
              panelTab.value = tab;
              isSheetOpen.value = true;
            }}
          >
            {t.tabs[tab]}
          </button>
        ))}
      </div>
      <div id="panel-content" class="panel-content" role="tabpanel" aria-labelledby={`tab-${chosen.tab}`} tabIndex={0}>
        <Content />
      </div>
    </aside>
  );
}
