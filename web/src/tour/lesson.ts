// What a lesson is: data. Steps change the scene, speak, point at a control, and ask; whether an answer is right is found by asking the engine
// (bench.ts), so a lesson never states a number that a picture could contradict.
import type { SceneDoc, Vec3 } from "../engine/types";
import type { Changes, Comparison } from "../state/compare";
import type { Language, PanelTab } from "../state/settings";
import { changed, type Bench } from "./bench";

/** In every language, or it does not compile. `$...$` is a formula, `**...**` a term, `` `...` `` what a control or file says. */
export type Text = Readonly<Record<Language, string>>;

/** A place on the surface with a letter, drawn as a pin: the learner can choose its pixel by a button, too. */
export interface Mark {
  letter: string;
  at: Vec3;
}

/** A control of the page. */
export interface ControlRef {
  tab: PanelTab;
  /** its data-testid; of a whole tab `tab-camera` */
  testid: string;
}

export interface Verdict {
  ok: boolean;
  /** what was found, and what is missing; of a right answer it stands before the reason */
  say?: Text;
}

/** What an answer is when the learner asks for it; the tests go this way, too. */
export type Solution =
  | { kind: "change"; changes: Changes | ((bench: Bench) => Promise<Changes>) }
  /** the pixel that shows this place is chosen */
  | { kind: "pick"; at: (bench: Bench) => Promise<Vec3> };

/** Something to be done: checked whenever the scene or the chosen pixel changes. */
export interface Task {
  kind: "task";
  text: Text;
  check: (bench: Bench) => Promise<Verdict>;
  hint: Text;
  because: Text;
  solution: Solution;
}

export interface Option {
  text: Text;
  /** to who chose it though it is wrong; of the right one it is not shown */
  reply: Text;
}

/** One of several answers. */
export interface Choice {
  kind: "choice";
  text: Text;
  options: readonly Option[];
  /** index of the right one, found by the engine */
  answer: (bench: Bench) => Promise<number>;
  because: Text;
}

/** A number. */
export interface Quantity {
  kind: "number";
  text: Text;
  unit: string;
  answer: (bench: Bench) => Promise<number>;
  /** how far off is right: absolute, or as a share of the answer */
  tolerance: { absolute: number } | { relative: number };
  /** answers that show a way of thinking: the first that fits is said */
  slips: readonly { fits: (given: number, answer: number) => boolean; say: Text }[];
  hint: Text;
  because: Text;
}

export type Ask = Task | Choice | Quantity;

export interface Step {
  title: Text;
  text: Text;
  /** on a line of its own; TeX, the same in all languages */
  formula?: string;
  /** what this step changes in the scene of the step before it */
  scene?: Changes;
  /** shown in place of the picture alone, until the next step */
  comparison?: Comparison;
  /** its pictures beside each other, not under a wipe */
  isSideBySide?: boolean;
  marks?: readonly Mark[];
  control?: ControlRef;
  ask?: Ask;
  /** shown once the question is answered */
  reveal?: { scene?: Changes; comparison?: Comparison };
}

export interface Lesson {
  /** what progress is kept under: never changes */
  id: string;
  title: Text;
  /** one line for the list */
  about: Text;
  scene: SceneDoc;
  /** the last one asks the question that ends the lesson */
  steps: readonly Step[];
}

/** The scene as a step begins: the lesson's own, with what all steps up to it change. What the learner did before does not matter to it. */
export function sceneOf(lesson: Lesson, step: number): SceneDoc {
  return lesson.steps.slice(0, step + 1).reduce((scene, { scene: changes }) => changed(scene, changes ?? []), lesson.scene);
}

export function isNumberRight({ tolerance }: Quantity, given: number, answer: number): boolean {
  return Math.abs(given - answer) <= ("absolute" in tolerance ? tolerance.absolute : tolerance.relative * Math.abs(answer));
}
