// The list of lessons, a dialog: which are done, where to go on.
import { useEffect, useRef } from "preact/hooks";
import { IconButton } from "../layout/icon-button";
import { lessons } from "./lessons";
import { isListOpen, startLesson } from "./player";
import { progress } from "./progress";
import { say, spoken } from "./words";

export default function List() {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    dialog.current?.showModal();
  }, []);
  const t = say.value;
  const { done, at } = progress.value;
  const close = () => (isListOpen.value = false);
  return (
    <dialog
      ref={dialog}
      class="tour-list"
      aria-labelledby="tour-list-title"
      data-testid="tour-list"
      onClose={close}
      onClick={(event) => event.target === dialog.current && close()}
    >
      <div class="tour-list-inner">
        <header class="section-head">
          <h2 id="tour-list-title">{t("title")}</h2>
          <IconButton icon="close" label={t("close")} isSmall testid="tour-list-close" onClick={close} />
        </header>
        <p>{t("intro")}</p>
        <ol>
          {lessons.map(({ id, title, about }, index) => {
            const isDone = done.includes(id);
            const goesOn = at?.lesson === id && at.step > 0;
            return (
              <li key={id}>
                <button type="button" data-done={isDone} data-testid={`tour-lesson-${id}`} onClick={() => startLesson(index)}>
                  <span class="tour-number-of">{isDone ? "✓" : index + 1}</span>
                  <span class="tour-name">
                    <strong>{spoken(title)}</strong>
                    {isDone ? <span class="visually-hidden"> ({t("done")})</span> : null}
                    <span>{spoken(about)}</span>
                  </span>
                  <span class="tour-go">{goesOn ? t("resume") : isDone ? t("again") : t("start")}</span>
                </button>
              </li>
            );
          })}
        </ol>
      </div>
    </dialog>
  );
}
