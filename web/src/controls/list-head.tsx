// Over a list of lights or objects: its title, and what adds, copies and removes.
import { useState } from "preact/hooks";
import { IconButton } from "../layout/icon-button";

/** What can be added. */
export interface Choice<Value extends string> {
  value: Value;
  label: string;
  help?: string;
}

export function ListHead<Value extends string>({
  words: t,
  choices,
  canCopy,
  canRemove,
  onAdd,
  onCopy,
  onRemove,
  testid,
}: {
  words: { title: string; add: string; copy: string; remove: string };
  choices: readonly Choice<Value>[];
  canCopy: boolean;
  canRemove: boolean;
  onAdd: (value: Value) => void;
  onCopy: () => void;
  onRemove: () => void;
  testid: string;
}) {
  const [isAdding, setAdding] = useState(false);
  return (
    <>
      <div class="section-head">
        <h2 class="group-title">{t.title}</h2>
        <div class="header-tools">
          <IconButton
            icon="add"
            label={t.add}
            isSmall
            isExpanded={isAdding}
            testid={`${testid}-add`}
            onClick={() => setAdding(!isAdding)}
          />
          <IconButton icon="copy" label={t.copy} isSmall isDisabled={!canCopy} testid={`${testid}-copy`} onClick={onCopy} />
          <IconButton icon="remove" label={t.remove} isSmall isDisabled={!canRemove} testid={`${testid}-remove`} onClick={onRemove} />
        </div>
      </div>
      {isAdding ? (
        <div class="choices" data-testid={`${testid}-add-choices`}>
          {choices.map(({ value, label, help }) => (
            <button
              key={value}
              class="term plain"
              type="button"
              data-help={help}
              data-testid={`${testid}-add-${value}`}
              onClick={() => {
                onAdd(value);
                setAdding(false);
              }}
            >
              {label}
            </button>
          ))}
        </div>
      ) : null}
    </>
  );
}
