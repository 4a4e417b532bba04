// The panel: the pixel's colour as the sum of its terms, every surface that it shows, what of it is drawn in the picture.
import { signal } from "@preact/signals";
import { percentText } from "../plots/number";
import type { Explanation } from "../engine/types";
import { say } from "../state/messages";
import { FragmentView } from "./fragment-view";
import { Lens } from "./lens";
import { ProfileView } from "./profile-view";
import { reportText } from "./report";
import { LobeView } from "./lobe-view";
import { hexOf, Result } from "./result";
import { named } from "./rows";
import { explainFailure, isStale, shownExplanation } from "./state";
import { VectorChoice } from "./vector-choice";
import { explainWords } from "./words";
import "../plots/plots.css";
import "./explain.css";

const copied = signal(false);

async function copy(e: Explanation): Promise<void> {
  const t = explainWords.peek();
  try {
    await navigator.clipboard.writeText(reportText(t, e));
    copied.value = true;
    setTimeout(() => (copied.value = false), 1800);
  } catch {
    say("warning", t.notCopied, "copy");
  }
}

/** What a screen reader says when another pixel is chosen. */
function announcement(e: Explanation): string {
  const f = e.fragments[0];
  return `${hexOf(e.bytes)}, ${f ? named(f.object, f.object_name) : explainWords.value.terms.background}`;
}

export default function ExplainContent() {
  const t = explainWords.value;
  const e = shownExplanation.value;
  if (explainFailure.value !== undefined) {
    return (
      <p class="x-failure" role="alert" data-testid="explain-failure">
        {explainFailure.value}
      </p>
    );
  }
  if (!e) {
    return (
      <p class="x-muted" aria-busy="true">
        {t.asking} …
      </p>
    );
  }
  const heaviest = e.fragments.reduce((best, f, i) => (f.weight > e.fragments[best]!.weight ? i : best), 0);
  return (
    <div class="x-content" data-testid="explain-content" data-stale={isStale.value} aria-busy={isStale.value}>
      <div class="x-top">
        <Lens />
        <VectorChoice e={e} />
      </div>
      <Result e={e} onCopy={() => void copy(e)} />
      <p class="visually-hidden" role="status">
        {copied.value ? t.copied : announcement(e)}
      </p>
      {e.fragments.map((f, i) => (
        <FragmentView key={i} e={e} f={f} index={i} open={i === heaviest} />
      ))}
      <LobeView e={e} />
      <ProfileView />
      {e.background_weight > 0 ? (
        <p class="x-note">{e.fragments.length === 0 ? t.onlyBackground : t.backgroundIs(percentText(e.background_weight))}</p>
      ) : null}
    </div>
  );
}
