// The button "Compare" of the stage and its card: which two pictures, and how they are shown.
import { signal } from "@preact/signals";
import { comparison, type Changes, type Comparison } from "../state/compare";
import { options } from "../state/engine";
import { pathText } from "../state/path";
import { kPairs } from "./settings";
import { splitLayout } from "./split";
import { words } from "./words";

const isOpen = signal(false);

function Choice({ label, isChosen, onChoose, testid }: { label: string; isChosen: boolean; onChoose: () => void; testid: string }) {
  return (
    <button type="button" class="compare-choice" aria-pressed={isChosen} onClick={onChoose} data-testid={testid}>
      {label}
    </button>
  );
}

function changesOf(value: Comparison, side: "left" | "right"): Changes {
  return value.kind === "settings" ? value[side] : [];
}

/** One side's own model or interpolation: a list of the words that the library knows. */
function SideSelect({ side, path, label }: { side: "left" | "right"; path: string; label: string }) {
  const { value } = comparison;
  const changes = changesOf(value, side);
  const stated = changes.find(([place]) => pathText(place) === path)?.[1];
  return (
    <label class="compare-select">
      <span>{label}</span>
      <select
        class="select"
        value={typeof stated === "string" ? stated : ""}
        data-testid={`compare-${side}-${path.split(".")[1]}`}
        onChange={(event) => {
          const word = event.currentTarget.value;
          const others = changes.filter(([place]) => pathText(place) !== path);
          const own: Changes = word === "" ? others : [...others, [path, word]];
          const left = side === "left" ? own : changesOf(value, "left");
          const right = side === "right" ? own : changesOf(value, "right");
          comparison.value = { kind: "settings", left, right };
        }}
      >
        <option value="">{words.value.asItIs}</option>
        {options.value.get(path)?.words.map(({ word }) => (
          <option key={word} value={word}>
            {word}
          </option>
        ))}
      </select>
    </label>
  );
}

function GpuChoices({ value }: { value: Extract<Comparison, { kind: "gpu" }> }) {
  const show = (word: typeof value.show) => (comparison.value = { ...value, show: word });
  return (
    <>
      <p class="compare-help">{words.value.gpuHelp}</p>
      <div class="compare-row" role="group" aria-label={words.value.show}>
        <Choice label={words.value.showWipe} isChosen={value.show === "wipe"} onChoose={() => show("wipe")} testid="gpu-wipe" />
        <Choice label={words.value.showGpu} isChosen={value.show === "gpu"} onChoose={() => show("gpu")} testid="gpu-only" />
        <Choice
          label={words.value.showDifference}
          isChosen={value.show === "difference"}
          onChoose={() => show("difference")}
          testid="gpu-show-difference"
        />
      </div>
      {value.show === "difference" && (
        <div class="compare-row" role="group" aria-label={words.value.gain}>
          {([1, 8, 64] as const).map((gain) => (
            <Choice
              key={gain}
              label={`× ${gain}`}
              isChosen={value.gain === gain}
              onChoose={() => (comparison.value = { ...value, gain })}
              testid={`gpu-gain-${gain}`}
            />
          ))}
        </div>
      )}
    </>
  );
}

function SettingsChoices({ value }: { value: Extract<Comparison, { kind: "settings" }> }) {
  // By what they say: a link brings changes of its own.
  const text = (sides: { left: Changes; right: Changes }) => JSON.stringify([sides.left, sides.right]);
  const chosen = kPairs.find((pair) => text(pair) === text(value));
  return (
    <>
      <div class="compare-row" role="group" aria-label={words.value.settings}>
        {kPairs.map((pair) => (
          <Choice
            key={pair.id}
            label={pair.name}
            isChosen={pair === chosen}
            onChoose={() => (comparison.value = { kind: "settings", left: pair.left, right: pair.right })}
            testid={`pair-${pair.id}`}
          />
        ))}
      </div>
      <fieldset class="compare-own">
        <legend>{words.value.custom}</legend>
        {(["left", "right"] as const).map((side) => (
          <div key={side} class="compare-side">
            <strong>{words.value[side]}</strong>
            <SideSelect side={side} path="shading.lighting" label={words.value.lighting} />
            <SideSelect side={side} path="shading.interpolation" label={words.value.interpolation} />
          </div>
        ))}
      </fieldset>
      <div class="compare-row" role="group" aria-label={words.value.layout}>
        <Choice
          label={words.value.showWipe}
          isChosen={splitLayout.value === "wipe"}
          onChoose={() => (splitLayout.value = "wipe")}
          testid="layout-wipe"
        />
        <Choice
          label={words.value.sideBySide}
          isChosen={splitLayout.value === "side"}
          onChoose={() => (splitLayout.value = "side")}
          testid="layout-side"
        />
      </div>
    </>
  );
}

export function CompareTool() {
  const { value } = comparison;
  const first = kPairs[1]!;
  return (
    <div
      class="compare-tool"
      onKeyDown={(event) => {
        if (event.key === "Escape" && isOpen.value) {
          event.stopPropagation();
          isOpen.value = false;
        }
      }}
    >
      <button
        type="button"
        class="tool text"
        aria-expanded={isOpen.value}
        aria-controls="compare-card"
        aria-pressed={value.kind !== "none"}
        onClick={() => (isOpen.value = !isOpen.value)}
        data-testid="compare"
      >
        {words.value.compare}
      </button>
      {isOpen.value && (
        <div id="compare-card" class="compare-card" role="group" aria-label={words.value.title}>
          <div class="compare-row">
            <Choice
              label={words.value.off}
              isChosen={value.kind === "none"}
              onChoose={() => (comparison.value = { kind: "none" })}
              testid="compare-none"
            />
            <Choice
              label={words.value.settings}
              isChosen={value.kind === "settings"}
              onChoose={() => (comparison.value = { kind: "settings", left: first.left, right: first.right })}
              testid="compare-settings"
            />
            <Choice
              label={words.value.gpu}
              isChosen={value.kind === "gpu"}
              onChoose={() => (comparison.value = { kind: "gpu", show: "wipe", gain: 8 })}
              testid="compare-gpu"
            />
          </div>
          {value.kind === "gpu" && <GpuChoices value={value} />}
          {value.kind === "settings" && <SettingsChoices value={value} />}
        </div>
      )}
    </div>
  );
}
