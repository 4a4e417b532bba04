// Places in a scene's JSON, `lights[2].attenuation.linear` or ["lights", 2, "attenuation", "linear"], and values read and written there. Nothing
// is changed in place: what is not on the way to the place is shared with the scene before, so signals see what is new.

export type PathStep = string | number;
export type Path = string | readonly PathStep[];

export function pathSteps(path: Path): readonly PathStep[] {
  if (typeof path !== "string") {
    return path;
  }
  const steps: PathStep[] = [];
  for (const part of path.matchAll(/([^.[\]]+)|\[(\d+)\]/g)) {
    steps.push(part[2] === undefined ? part[1]! : Number(part[2]));
  }
  return steps;
}

/** As messages and the command write it. */
export function pathText(path: Path): string {
  return pathSteps(path).reduce<string>(
    (text, step) => (typeof step === "number" ? `${text}[${step}]` : text === "" ? step : `${text}.${step}`),
    "",
  );
}

export function isTable(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** The value there; undefined where nothing is stated. */
export function valueAt(root: unknown, path: Path): unknown {
  let value: unknown = root;
  for (const step of pathSteps(path)) {
    if (Array.isArray(value)) {
      value = typeof step === "number" ? value[step] : undefined;
    } else if (isTable(value)) {
      value = Object.hasOwn(value, step) ? value[step] : undefined;
    } else {
      return undefined;
    }
  }
  return value;
}

/** Tables that are there whether stated or not: one that has become empty says nothing. Of others (`fog: {}`) being there is what they say. */
const kAlwaysThere = new Set<PathStep>(["image", "tone", "camera", "shading", "attenuation"]);

/**
 * A copy of the root with the value there; undefined takes the key (or the list's entry) away. Tables on the way are made where there are none; a
 * number or text that stands where a table is needed (`shadow: true`) gives way to it.
 */
export function withValue<T>(root: T, path: Path, value: unknown): T {
  return withSteps(root, pathSteps(path), value) as T;
}

function withSteps(root: unknown, steps: readonly PathStep[], value: unknown): unknown {
  const step = steps[0];
  if (step === undefined) {
    return value;
  }
  const inner = steps.slice(1);
  if (typeof step === "number") {
    const list: unknown[] = Array.isArray(root) ? [...root] : [];
    if (inner.length === 0 && value === undefined) {
      list.splice(step, 1);
    } else {
      list[step] = withSteps(list[step], inner, value);
    }
    return list;
  }
  const table: Record<string, unknown> = isTable(root) ? { ...root } : {};
  const before = Object.hasOwn(table, step) ? table[step] : undefined;
  if (value === undefined && (before === undefined || (inner.length > 0 && typeof before !== "object"))) {
    return isTable(root) ? root : table;
  }
  const after = withSteps(before, inner, value);
  const saysNothing = isTable(after) && Object.keys(after).length === 0 && kAlwaysThere.has(step);
  if (after === undefined || saysNothing) {
    delete table[step];
  } else {
    Object.defineProperty(table, step, { value: after, enumerable: true, configurable: true, writable: true });
  }
  return table;
}
