// The tour as it runs: which step is shown, what was answered, what is said to it. The card shows it (card.tsx); the page's state is changed here.
import { batch, computed, effect, signal, untracked, type ReadonlySignal } from "@preact/signals";
import type { SceneDoc, Vec3 } from "../engine/types";
import { splitLayout } from "../gpu/split";
import { worldToPixel } from "../stage/projection";
import { comparison, wipe } from "../state/compare";
import { engine } from "../state/engine";
import { retract, say as sayOnPage } from "../state/messages";
import { fullRequest, fullSize, picture } from "../state/picture";
import { canUndo, editLab, isDragging, labDoc, rememberScene, resetScene, scene, updateAll } from "../state/scene";
import { selectedLight, selectedPixel, selectObject } from "../state/selection";
import { isSheetOpen, panelTab } from "../state/settings";
import { Bench, changed } from "./bench";
import { pointAt } from "./highlight";
import { isNumberRight, sceneOf, type Ask, type Lesson, type Mark, type Step, type Text } from "./lesson";
import { lessons } from "./lessons";
import { markDone, markPlace, progress } from "./progress";
import { spoken, textOf } from "./words";

export interface Place {
  lesson: number;
  step: number;
}

/** `shown`: the tour gave the answer itself */
export type Outcome = "open" | "right" | "shown";

export interface Feedback {
  kind: "right" | "wrong" | "note";
  texts: readonly Text[];
}

/** What the tour's messages are about. */
const kAbout = "tour";

/** Changes settle for this long before they are checked. */
const kSettleMilliseconds = 180;

export const place = signal<Place | undefined>(undefined);
export const isListOpen = signal(false);
export const outcome = signal<Outcome>("open");
export const feedback = signal<Feedback | undefined>(undefined);
/** Indices of the options that were chosen and are wrong. */
export const wrongOptions = signal<readonly number[]>([]);
export const rightOption = signal<number | undefined>(undefined);
export const isHintOpen = signal(false);
/** Counts the steps that were shown: the card moves the focus when it grows. */
export const shownSteps = signal(0);

export const lesson: ReadonlySignal<Lesson | undefined> = computed(() => place.value && lessons[place.value.lesson]);
export const step: ReadonlySignal<Step | undefined> = computed(() => lesson.value?.steps[place.value!.step]);
export const marks: ReadonlySignal<readonly Mark[]> = computed(() => step.value?.marks ?? []);
export const isLastStep: ReadonlySignal<boolean> = computed(() => place.value?.step === (lesson.value?.steps.length ?? 0) - 1);

let restore: (() => void) | undefined;
/** Counts what was shown: an answer that comes late is for a step that is gone. */
let started = 0;
/** The scene as the step left it to the reader. */
let fresh: SceneDoc | undefined;

/** What the page is apart from the scene comes back, too. */
function rememberPage(): () => void {
  const bringBackScene = rememberScene();
  const [compared, layout, split] = [comparison.peek(), splitLayout.peek(), wipe.peek()];
  const [pixel, light, tab] = [selectedPixel.peek(), selectedLight.peek(), panelTab.peek()];
  return () =>
    batch(() => {
      bringBackScene();
      comparison.value = compared;
      splitLayout.value = layout;
      wipe.value = split;
      selectedPixel.value = pixel;
      selectedLight.value = light;
      panelTab.value = tab;
    });
}

function benchOf(start: number): Bench | undefined {
  const current = engine.peek();
  const at = place.peek();
  const pixel = selectedPixel.peek();
  if (!current || !at || start !== started) {
    return undefined;
  }
  return new Bench(current, scene.peek(), sceneOf(lessons[at.lesson]!, at.step), pixel && { request: fullRequest.peek(), ...pixel });
}

/** The scene as the step began: what questions are about, whatever was tried since. */
function startBench(): Bench | undefined {
  const at = place.peek();
  const current = engine.peek();
  return at && current && new Bench(current, sceneOf(lessons[at.lesson]!, at.step));
}

function show(next: Place): void {
  const chosen = lessons[next.lesson]!;
  const { comparison: compared, isSideBySide, control } = chosen.steps[next.step]!;
  restore ??= rememberPage();
  started++;
  batch(() => {
    place.value = next;
    isListOpen.value = false;
    outcome.value = "open";
    feedback.value = undefined;
    wrongOptions.value = [];
    rightOption.value = undefined;
    isHintOpen.value = false;
    setScene(sceneOf(chosen, next.step));
    selectedPixel.value = undefined;
    comparison.value = compared ?? { kind: "none" };
    splitLayout.value = isSideBySide ? "side" : "wipe";
    wipe.value = 0.5;
    isSheetOpen.value = false;
    shownSteps.value++;
  });
  retract(kAbout);
  pointAt(control);
  markPlace(chosen.id, next.step);
}

/** A scene of the tour's: nothing before it is left to undo. */
function setScene(doc: SceneDoc): void {
  fresh = doc;
  resetScene(doc);
  selectObject(0);
  selectedLight.value = (doc.lights?.length ?? 0) > 0 ? 0 : undefined;
}

export function startLesson(index: number): void {
  const { at } = progress.peek();
  const chosen = lessons[index]!;
  const isGoingOn = at?.lesson === chosen.id && at.step > 0 && at.step < chosen.steps.length;
  show({ lesson: index, step: isGoingOn ? at.step : 0 });
}

export function nextStep(): void {
  const at = place.peek();
  if (at && at.step + 1 < lessons[at.lesson]!.steps.length) {
    show({ ...at, step: at.step + 1 });
  }
}

export function previousStep(): void {
  const at = place.peek();
  if (at && at.step > 0) {
    show({ ...at, step: at.step - 1 });
  }
}

export function repeatStep(): void {
  const at = place.peek();
  if (at) {
    show(at);
  }
}

export function nextLesson(): void {
  const at = place.peek();
  if (at && at.lesson + 1 < lessons.length) {
    show({ lesson: at.lesson + 1, step: 0 });
  }
}

/** The reader's own scene comes back with its steps of undo; `keeps` puts the lesson's scene on top of them. */
export function leave(keeps = false): void {
  if (!place.peek()) {
    return;
  }
  const last = labDoc.peek();
  const bringBack = restore;
  end();
  bringBack?.();
  if (keeps) {
    editLab(() => last);
    comparison.value = { kind: "none" };
  } else {
    sayOnPage("note", spoken(textOf("backAgain")), kAbout);
  }
}

function end(): void {
  started++;
  restore = undefined;
  place.value = undefined;
  pointAt(undefined);
}

/** Ends the tour, and leaves the scene, where another one took the lesson's place: an example, a file. The function that it returns ends that. */
export function watchScene(): () => void {
  return effect(() => {
    if (place.value && !canUndo.value && scene.value !== fresh) {
      untracked(end);
    }
  });
}

function finish(how: Outcome, texts: readonly (Text | undefined)[]): void {
  const current = step.peek()!;
  outcome.value = how;
  feedback.value = { kind: "right", texts: texts.filter((text) => text !== undefined && text.en !== "") as Text[] };
  if (current.reveal?.scene) {
    updateAll(current.reveal.scene, "tour");
  }
  if (current.reveal?.comparison) {
    comparison.value = current.reveal.comparison;
  }
  if (isLastStep.peek()) {
    markDone(lesson.peek()!.id);
  }
}

const openAsk = <K extends Ask["kind"]>(kind: K): Extract<Ask, { kind: K }> | undefined => {
  const ask = step.peek()?.ask;
  return ask?.kind === kind && outcome.peek() === "open" ? (ask as Extract<Ask, { kind: K }>) : undefined;
};

export async function choose(option: number): Promise<void> {
  const ask = openAsk("choice");
  const start = started;
  const answer = await (startBench() && ask?.answer(startBench()!));
  if (!ask || answer === undefined || start !== started || outcome.peek() !== "open") {
    return;
  }
  if (option === answer) {
    rightOption.value = answer;
    finish("right", [textOf("right"), ask.because]);
  } else {
    wrongOptions.value = [...wrongOptions.peek().filter((other) => other !== option), option];
    feedback.value = { kind: "wrong", texts: [ask.options[option]!.reply] };
  }
}

/** A number as people write it: with a point or a comma, a minus of either kind, maybe with its unit. */
export function parsedNumber(text: string): number | undefined {
  const plain = text.trim().replace(/\s*°$/, "").replace("−", "-").replace(",", ".");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : undefined;
}

export async function answerNumber(text: string): Promise<void> {
  const ask = openAsk("number");
  const start = started;
  const given = parsedNumber(text);
  if (ask && given === undefined) {
    feedback.value = { kind: "wrong", texts: [textOf("noNumber")] };
    return;
  }
  const answer = await (startBench() && ask?.answer(startBench()!));
  if (!ask || given === undefined || answer === undefined || start !== started) {
    return;
  }
  if (isNumberRight(ask, given, answer)) {
    finish("right", [textOf("right"), ask.because]);
    return;
  }
  const slip = ask.slips.find(({ fits }) => fits(given, answer));
  feedback.value = { kind: "wrong", texts: slip ? [slip.say] : [textOf(given < answer ? "tooLow" : "tooHigh"), ask.hint] };
}

/** The pixel of the full picture that shows a place of the world, by the latest view. */
function pixelOf(at: Vec3): { x: number; y: number } | undefined {
  const view = picture.peek()?.view;
  const point = view && worldToPixel(view, at);
  const { width, height } = fullSize.peek();
  if (!view || !point) {
    return undefined;
  }
  const [x, y] = [Math.floor((point.x * width) / view.width), Math.floor((point.y * height) / view.height)];
  return x >= 0 && y >= 0 && x < width && y < height ? { x, y } : undefined;
}

export function pick(at: Vec3): void {
  selectedPixel.value = pixelOf(at);
}

/** The tour does it itself. */
export async function showAnswer(): Promise<void> {
  const ask = step.peek()?.ask;
  const bench = startBench();
  const start = started;
  if (!ask || !bench || outcome.peek() !== "open") {
    return;
  }
  if (ask.kind === "task") {
    const { solution } = ask;
    const at = solution.kind === "pick" ? await solution.at(bench) : undefined;
    const changes =
      solution.kind === "change" ? (typeof solution.changes === "function" ? await solution.changes(bench) : solution.changes) : [];
    if (start !== started || outcome.peek() !== "open") {
      return;
    }
    batch(() => {
      outcome.value = "shown";
      setScene(changed(bench.scene, changes));
      if (at) {
        pick(at);
      }
      finish("shown", [textOf("solution"), ask.because]);
    });
    return;
  }
  const answer = await ask.answer(bench);
  if (start !== started || outcome.peek() !== "open") {
    return;
  }
  if (ask.kind === "choice") {
    rightOption.value = answer;
    finish("shown", [textOf("solution"), ask.because]);
  } else {
    const digits = answer < 10 ? 2 : 0;
    const text: Text = { en: `${answer.toFixed(digits)}${ask.unit}.`, it: `${answer.toFixed(digits).replace(".", ",")}${ask.unit}.` };
    finish("shown", [textOf("theAnswer"), text, ask.because]);
  }
}

async function checkTask(start: number): Promise<void> {
  const ask = openAsk("task");
  const bench = benchOf(start);
  if (!ask || !bench) {
    return;
  }
  try {
    const verdict = await ask.check(bench);
    if (start !== started || outcome.peek() !== "open" || scene.peek() !== bench.scene) {
      return;
    }
    if (verdict.ok) {
      finish("right", [textOf("right"), verdict.say, ask.because]);
    } else {
      feedback.value = verdict.say ? { kind: "note", texts: [verdict.say] } : undefined;
    }
  } catch {
    // a scene that the engine refuses: the page says why
  }
}

/** Checks a task whenever the scene or the chosen pixel has changed and settled. The function that it returns ends that. */
export function watchTasks(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return effect(() => {
    const isUntouched = scene.value === fresh && selectedPixel.value === undefined;
    void fullRequest.value;
    clearTimeout(timer);
    if (step.value?.ask?.kind === "task" && outcome.value === "open" && engine.value && !isDragging.value && !isUntouched) {
      const start = started;
      timer = setTimeout(() => void checkTask(start), kSettleMilliseconds);
    }
  });
}
