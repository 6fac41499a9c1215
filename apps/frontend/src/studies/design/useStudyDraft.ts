import type { Study } from '@ubii/proto';
import { computed, onScopeDispose, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { studyErrors, type StudyErrors } from './study-errors.ts';

/** Time without changes after which a draft is saved, milliseconds. */
const SETTLE_MS = 600;
const MAX_STEPS = 100;

export type SaveState = 'saved' | 'saving' | 'changed' | 'invalid' | 'refused';

/** A study as it is edited. It is saved automatically, and its changes can be undone. */
export interface StudyDraft {
  readonly study: ComputedRef<Study>;
  readonly errors: ComputedRef<StudyErrors>;
  readonly state: ComputedRef<SaveState>;
  readonly canUndo: ComputedRef<boolean>;
  readonly canRedo: ComputedRef<boolean>;
  /** @param gesture consecutive changes of the same gesture are one step, such as letters of a name */
  change(part: Partial<Study>, gesture?: string): void;
  undo(): void;
  redo(): void;
  /** Saves now what is not saved yet. */
  flush(): Promise<void>;
}

/** @param save returns what the master has now; undefined when the master refused it */
export function useStudyDraft(
  first: Study,
  save: (study: Study) => Promise<Study | undefined>,
): StudyDraft {
  const current = shallowRef(first);
  const past = shallowRef<readonly Study[]>([]);
  const future = shallowRef<readonly Study[]>([]);
  const saved = shallowRef(first);
  const isSaving = shallowRef(false);
  const isRefused = shallowRef(false);
  const errors = computed(() => studyErrors(current.value));
  const isInvalid = computed(() => Object.keys(errors.value).length > 0);
  const isChanged = computed(() => !isSame(current.value, saved.value));
  let lastGesture: string | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;

  async function flush(): Promise<void> {
    clearTimeout(timer);
    // The next save begins when the running one has ended, with its revision.
    if (isSaving.value || isInvalid.value || !isChanged.value) return;
    isSaving.value = true;
    const sent = current.value;
    const { revision } = saved.value;
    const reply = await save({ ...sent, revision });
    isSaving.value = false;
    isRefused.value = reply === undefined;
    if (reply === undefined) return;
    saved.value = { ...sent, ...ofMaster(reply) };
    current.value = { ...current.value, ...ofMaster(reply) };
    await flush();
  }
  function show(study: Study): void {
    current.value = { ...study, ...ofMaster(saved.value) };
    isRefused.value = false;
    clearTimeout(timer);
    timer = setTimeout(() => void flush(), SETTLE_MS);
  }
  function move(from: ShallowRef<readonly Study[]>, to: ShallowRef<readonly Study[]>): void {
    const target = from.value.at(-1);
    if (target === undefined) return;
    from.value = from.value.slice(0, -1);
    to.value = [...to.value, current.value];
    lastGesture = undefined;
    show(target);
  }
  onScopeDispose(() => void flush());
  return {
    study: computed(() => current.value),
    errors,
    state: computed(() => {
      if (isSaving.value) return 'saving';
      if (isRefused.value) return 'refused';
      if (!isChanged.value) return 'saved';
      return isInvalid.value ? 'invalid' : 'changed';
    }),
    canUndo: computed(() => past.value.length > 0),
    canRedo: computed(() => future.value.length > 0),
    change(part, gesture) {
      if (gesture === undefined || gesture !== lastGesture)
        past.value = [...past.value, current.value].slice(-MAX_STEPS);
      lastGesture = gesture;
      future.value = [];
      show({ ...current.value, ...part });
    },
    undo: () => move(past, future),
    redo: () => move(future, past),
    flush,
  };
}

/** What the master sets. */
const ofMaster = ({
  id,
  revision,
  consentVersion,
  earlierConsentTexts,
  participantCount,
  runCount,
  changedMs,
}: Study): Partial<Study> => ({
  id,
  revision,
  consentVersion,
  earlierConsentTexts,
  participantCount,
  runCount,
  changedMs,
});

/** Whether both have what people wrote alike. */
function isSame(one: Study, other: Study): boolean {
  const written = (study: Study): string => JSON.stringify({ ...study, ...ofMaster(one) });
  return written(one) === written(other);
}
