// What the tour itself says, beside its lessons.
import { computed, type ReadonlySignal } from "@preact/signals";
import { language } from "../state/settings";
import type { Text } from "./lesson";

const kWords = {
  tour: { en: "Tour", it: "Lezioni" },
  title: { en: "Eight short lessons", it: "Otto brevi lezioni" },
  intro: {
    en: "Each changes the scene, asks you to try something, and ends with a question. Your own scene comes back when you leave.",
    it: "Ognuna cambia la scena, ti fa provare qualcosa e finisce con una domanda. La tua scena torna quando esci.",
  },
  start: { en: "Start", it: "Comincia" },
  resume: { en: "Go on", it: "Riprendi" },
  again: { en: "Again", it: "Di nuovo" },
  done: { en: "done", it: "fatta" },
  close: { en: "Close", it: "Chiudi" },
  lesson: { en: "Lesson", it: "Lezione" },
  step: { en: "Step", it: "Passo" },
  of: { en: "of", it: "di" },
  back: { en: "Back", it: "Indietro" },
  next: { en: "Next", it: "Avanti" },
  skip: { en: "Skip", it: "Salta" },
  leave: { en: "Leave", it: "Esci" },
  all: { en: "All lessons", it: "Tutte le lezioni" },
  nextLesson: { en: "Next lesson", it: "Prossima lezione" },
  keep: { en: "Leave and keep this scene", it: "Esci e tieni questa scena" },
  try: { en: "Try it", it: "Prova" },
  question: { en: "Question", it: "Domanda" },
  check: { en: "Check", it: "Controlla" },
  answer: { en: "Your answer", it: "La tua risposta" },
  hint: { en: "A hint", it: "Un aiuto" },
  showMe: { en: "Show me", it: "Mostrami" },
  choose: { en: "Read the pixel at", it: "Leggi il pixel in" },
  control: { en: "Show the control", it: "Mostra il comando" },
  right: { en: "Right.", it: "Giusto." },
  solution: { en: "This is how:", it: "Ecco come:" },
  theAnswer: { en: "The answer:", it: "La risposta:" },
  notYet: { en: "Not yet.", it: "Non ancora." },
  tooLow: { en: "Too little.", it: "Troppo poco." },
  tooHigh: { en: "Too much.", it: "Troppo." },
  noNumber: { en: "That is no number.", it: "Questo non è un numero." },
  reset: { en: "Start this step again", it: "Ricomincia questo passo" },
  finished: { en: "That was the lesson.", it: "La lezione è finita." },
  backAgain: { en: "Your scene is back.", it: "La tua scena è tornata." },
} satisfies Record<string, Text>;

export type TourWord = keyof typeof kWords;

/** A text of a lesson in the language of the page. */
export const spoken = (text: Text): string => text[language.value];

export const say: ReadonlySignal<(word: TourWord) => string> = computed(() => {
  const chosen = language.value;
  return (word) => kWords[word][chosen];
});

export const textOf = (word: TourWord): Text => kWords[word];
