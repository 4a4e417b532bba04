// The light whose vectors and lobe are shown.
import { named } from "./rows";
import { chosenLight, subject } from "./state";
import { explainWords } from "./words";

export function LightChoice({ testId }: { testId: string }) {
  const current = subject.value;
  const lights = current?.shading.lights ?? [];
  if (!current || lights.length < 2) {
    return null;
  }
  return (
    <label class="x-of-light">
      {explainWords.value.ofLight}{" "}
      <select
        value={String(lights[current.light]!.light)}
        onChange={(event) => (chosenLight.value = Number(event.currentTarget.value))}
        data-testid={testId}
      >
        {lights.map((light) => (
          <option key={light.light} value={String(light.light)}>
            {named(light.light, light.name)}
          </option>
        ))}
      </select>
    </label>
  );
}
