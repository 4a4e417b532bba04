// The card of a lesson: what the step says, what it asks, what is said to an answer, and the way on.
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { Tex } from "../explain/tex";
import { IconButton } from "../layout/icon-button";
import { Icon } from "../layout/icons";
import { isSheetOpen, language } from "../state/settings";
import { goTo } from "./highlight";
import type { Choice, Quantity, Step } from "./lesson";
import { lessons } from "./lessons";
import {
  answerNumber,
  choose,
  feedback,
  isHintOpen,
  isLastStep,
  isListOpen,
  leave,
  lesson,
  nextLesson,
  nextStep,
  outcome,
  pick,
  place,
  previousStep,
  repeatStep,
  rightOption,
  showAnswer,
  shownSteps,
  step,
  wrongOptions,
} from "./player";
import { Prose } from "./prose";
import { say, spoken } from "./words";

/** Italian has a comma where English has a point. */
function localFormula(tex: string): string {
  return language.value === "it" ? tex.replace(/(\d)\.(\d)/g, "$1{,}$2") : tex;
}

function Options({ ask }: { ask: Choice }) {
  return (
    <div class="tour-options" role="group" aria-labelledby="tour-ask">
      {ask.options.map((option, index) => {
        const state = rightOption.value === index ? "right" : wrongOptions.value.includes(index) ? "wrong" : "open";
        return (
          <button
            key={index}
            type="button"
            class="tour-option"
            data-state={state}
            disabled={outcome.value !== "open"}
            aria-pressed={state !== "open"}
            data-testid={`tour-option-${index}`}
            onClick={() => void choose(index)}
          >
            <Prose text={option.text} />
          </button>
        );
      })}
    </div>
  );
}

function NumberAnswer({ ask }: { ask: Quantity }) {
  const [text, setText] = useState("");
  return (
    <form
      class="tour-number"
      onSubmit={(event) => {
        event.preventDefault();
        void answerNumber(text);
      }}
    >
      <label for="tour-answer">{say.value("answer")}</label>
      <input
        id="tour-answer"
        inputMode="decimal"
        autocomplete="off"
        value={text}
        disabled={outcome.value !== "open"}
        data-testid="tour-answer"
        onInput={(event) => setText(event.currentTarget.value)}
      />
      <span aria-hidden="true">{ask.unit}</span>
      <button type="submit" class="action" disabled={outcome.value !== "open"} data-testid="tour-check">
        {say.value("check")}
      </button>
    </form>
  );
}

function Ask({ ask }: { ask: NonNullable<Step["ask"]> }) {
  const t = say.value;
  const hint = ask.kind === "choice" ? undefined : ask.hint;
  const isOpen = outcome.value === "open";
  const mayShow = isOpen && (isHintOpen.value || wrongOptions.value.length > 0);
  return (
    <div class="tour-ask" data-kind={ask.kind} data-outcome={outcome.value} data-testid="tour-ask">
      <p id="tour-ask">
        <strong class="tour-tag">{t(ask.kind === "task" ? "try" : "question")}</strong> <Prose text={ask.text} />
      </p>
      {ask.kind === "choice" ? <Options ask={ask} /> : ask.kind === "number" ? <NumberAnswer ask={ask} /> : null}
      {isHintOpen.value && isOpen && hint ? (
        <p class="tour-hint" data-testid="tour-hint-text">
          <Prose text={hint} />
        </p>
      ) : null}
      {isOpen && ((hint && !isHintOpen.value) || mayShow) ? (
        <div class="tour-help">
          {hint && !isHintOpen.value ? (
            <button type="button" class="link" data-testid="tour-hint" onClick={() => (isHintOpen.value = true)}>
              {t("hint")}
            </button>
          ) : null}
          {mayShow ? (
            <button type="button" class="link" data-testid="tour-show" onClick={() => void showAnswer()}>
              {t("showMe")}
            </button>
          ) : null}
        </div>
      ) : null}
    </div>
  );
}

/** Said aloud by screen readers as it changes. */
function Said() {
  const said = feedback.value;
  return (
    <div class="tour-said" role="status" data-kind={said?.kind} data-testid="tour-feedback">
      {said?.texts.map((text, index) => (
        <p key={index}>
          <Prose text={text} />
        </p>
      ))}
    </div>
  );
}

function Ways() {
  const t = say.value;
  const isDone = outcome.value !== "open";
  const hasNextLesson = place.value!.lesson + 1 < lessons.length;
  return (
    <footer class="tour-ways">
      <button type="button" class="action" disabled={place.value!.step === 0} data-testid="tour-back" onClick={previousStep}>
        {t("back")}
      </button>
      {!isLastStep.value ? (
        <button type="button" class={isDone || !step.value?.ask ? "action main" : "action"} data-testid="tour-next" onClick={nextStep}>
          {isDone || !step.value?.ask ? t("next") : t("skip")}
        </button>
      ) : isDone && hasNextLesson ? (
        <button type="button" class="action main" data-testid="tour-next-lesson" onClick={nextLesson}>
          {t("nextLesson")}
        </button>
      ) : (
        <button type="button" class="action" data-testid="tour-all" onClick={() => (isListOpen.value = true)}>
          {t("all")}
        </button>
      )}
      {isLastStep.value && isDone ? (
        <button type="button" class="link" data-testid="tour-keep" onClick={() => leave(true)}>
          {t("keep")}
        </button>
      ) : null}
    </footer>
  );
}

export default function Card() {
  const heading = useRef<HTMLHeadingElement>(null);
  const body = useRef<HTMLDivElement>(null);
  const counted = shownSteps.value;
  useLayoutEffect(() => {
    heading.current?.focus({ preventScroll: true });
    body.current?.scrollTo(0, 0);
  }, [counted]);
  const said = feedback.value;
  useEffect(() => {
    // what was just said must not lie below the card's edge
    if (said) {
      body.current?.querySelector(".tour-said")?.scrollIntoView({ block: "nearest" });
    }
  }, [said]);
  // the stage makes room for the card
  useLayoutEffect(() => {
    document.documentElement.dataset["tour"] = "on";
    return () => delete document.documentElement.dataset["tour"];
  }, []);
  const [at, chosen, current] = [place.value, lesson.value, step.value];
  if (!at || !chosen || !current) {
    return null;
  }
  const t = say.value;
  return (
    <section class="tour-card" aria-labelledby="tour-title" data-compact={isSheetOpen.value} data-testid="tour-card">
      <header class="tour-head">
        <p class="tour-place" data-testid="tour-place">
          <button type="button" class="link" title={t("all")} data-testid="tour-list-open" onClick={() => (isListOpen.value = true)}>
            {t("lesson")} {at.lesson + 1}: {spoken(chosen.title)}
          </button>
        </p>
        <IconButton icon="reset" label={t("reset")} isSmall testid="tour-repeat" onClick={repeatStep} />
        <IconButton icon="close" label={t("leave")} isSmall testid="tour-leave" onClick={() => leave()} />
      </header>
      <ol class="tour-steps" aria-label={`${t("step")} ${at.step + 1} ${t("of")} ${chosen.steps.length}`}>
        {chosen.steps.map((_, index) => (
          <li key={index} data-state={index < at.step ? "past" : index === at.step ? "now" : "ahead"} />
        ))}
      </ol>
      <div class="tour-body" ref={body} key={counted}>
        <h2 id="tour-title" tabIndex={-1} ref={heading}>
          <span class="visually-hidden">
            {t("step")} {at.step + 1} {t("of")} {chosen.steps.length}:{" "}
          </span>
          {spoken(current.title)}
        </h2>
        <p class="tour-text">
          <Prose text={current.text} />
        </p>
        {current.formula ? (
          <div class="tour-formula">
            <Tex tex={localFormula(current.formula)} block />
          </div>
        ) : null}
        <div class="tour-places">
          {current.marks?.map(({ letter, at: point }) => (
            <button key={letter} type="button" class="tour-mark" data-testid={`tour-mark-${letter}`} onClick={() => pick(point)}>
              <Icon name="pixel" /> {t("choose")} {letter}
            </button>
          ))}
          {current.control ? (
            <button type="button" class="tour-mark" data-testid="tour-control" onClick={() => goTo(current.control!)}>
              <Icon name="settings" /> {t("control")}
            </button>
          ) : null}
        </div>
        {current.ask ? <Ask ask={current.ask} /> : null}
        <Said />
      </div>
      <Ways />
    </section>
  );
}
