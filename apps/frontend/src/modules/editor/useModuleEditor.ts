import { ConnectionError } from '@ubii/client-web';
import { ModuleOrigin, type ProcessingModule } from '@ubii/proto';
import { computed, ref, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import { usePoll } from '../../connection/poll.ts';
import { tryRequest, useAttempt, type RequestError } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { dropDraft, keepDraft, readDraft } from '../draft/draft-store.ts';
import { draftProblems, isFatalProblem, type DraftProblems } from '../draft/draft-problems.ts';
import { editedModule, type EditedModule } from '../draft/edited-module.ts';
import {
  draftKey,
  draftOf,
  isSameDraft,
  moduleOf,
  type ModuleDraft,
} from '../draft/module-draft.ts';
import { reconcile } from '../draft/reconcile.ts';
import { keepSame } from './code/keep-same.ts';

/** Interval of requests, milliseconds, to notice changed files on the master's disk. */
const INTERVAL_MS = 1000;

/** `readonly`: built in, or from a folder of the master, and cannot be changed here. [SE-22] */
export type EditorStatus = 'loading' | 'missing' | 'readonly' | 'ready';

/** State of the module editor. */
export interface ModuleEditor {
  readonly status: ComputedRef<EditorStatus>;
  readonly draft: Readonly<ShallowRef<ModuleDraft | undefined>>;
  readonly module: EditedModule;
  /** Version of the master that the draft is based on; `undefined` if never saved. */
  readonly base: Readonly<ShallowRef<ModuleDraft | undefined>>;
  /** The version of another user, while a conflict is open. */
  readonly theirs: Readonly<ShallowRef<ModuleDraft | undefined>>;
  /** True when the module was deleted on the master while there are unsaved changes. */
  readonly isGone: Readonly<Ref<boolean>>;
  readonly isChanged: ComputedRef<boolean>;
  readonly problems: ComputedRef<DraftProblems>;
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  readonly isSaving: Readonly<Ref<boolean>>;
  edit(change: Partial<ModuleDraft>): void;
  /** Discards unsaved changes. */
  discard(): void;
  takeTheirs(): void;
  keepMine(): void;
  /** @returns the module as it is stored now; undefined when it was refused */
  save(): Promise<ProcessingModule | undefined>;
}

export function useModuleEditor(
  /** Name in the URL: that of the module, or of the draft of a new one. */
  address: () => string,
  taken: () => readonly string[],
  onOverwritten: () => void,
): ModuleEditor {
  const { client, isConnected } = useConnection();
  const kept = readDraft(address());
  const draft = shallowRef(kept?.draft);
  const base = shallowRef(kept?.base);
  const theirs = shallowRef<ModuleDraft>();
  /** Version that the user rejected, to ask only once. */
  const refused = shallowRef<ModuleDraft>();
  const isGone = ref(false);
  const isKnown = ref(false);
  const isReadonly = ref(false);
  const { problem: failure, isBusy: isSaving, attempt } = useAttempt();

  const module = editedModule(() => draft.value);
  const baseKey = computed(() => base.value && draftKey(base.value));
  const isChanged = computed(
    () => draft.value !== undefined && draftKey(draft.value, module.text.value) !== baseKey.value,
  );
  const problems = computed<DraftProblems>((before) => {
    const own = base.value?.name;
    const next: DraftProblems = draft.value
      ? draftProblems(
          draft.value,
          new Set(taken().filter((name) => name !== own)),
          module.text.value,
        )
      : new Map();
    return keepSame(before, next, (one) => [...one]);
  });

  function take(next: ModuleDraft): void {
    base.value = next;
    draft.value = next;
    theirs.value = undefined;
    refused.value = undefined;
  }

  /** Handles the version of the master. */
  function look(stored: ModuleDraft | undefined): void {
    isKnown.value = true;
    if (isSaving.value) return;
    const seen = reconcile({
      draft: draft.value,
      base: base.value,
      stored,
      refused: refused.value,
    });
    isGone.value = seen.kind === 'gone';
    if (seen.kind === 'take') {
      const hadOne = base.value !== undefined;
      take(seen.draft);
      if (hadOne) onOverwritten();
    } else if (seen.kind === 'same') {
      base.value = seen.base;
      theirs.value = undefined;
    } else theirs.value = seen.kind === 'ask' ? seen.theirs : undefined;
  }

  async function refresh(): Promise<void> {
    const name = base.value?.name ?? address();
    await tryRequest(async () => {
      const { elements } = await client.call('processingModuleDatabaseGet', { name });
      const found = elements[0];
      const origin = found?.extension?.origin;
      isReadonly.value = found !== undefined && origin !== ModuleOrigin.MODULE_ORIGIN_STORED;
      // The name of a new module is in use: the field shows the error.
      if (isReadonly.value && draft.value) {
        isKnown.value = true;
        isReadonly.value = false;
      } else look(found && draftOf(found));
    }, handleRefusal);
  }
  function handleRefusal(cause: RequestError): void {
    if (cause instanceof ConnectionError) return;
    if (cause.code === 'not_found') look(undefined);
    else failure.value = cause.message;
  }
  usePoll(refresh, INTERVAL_MS, isConnected);

  watch([draft, base], () => {
    if (!draft.value) return;
    if (!isChanged.value) dropDraft(address());
    else if (!keepDraft(address(), { draft: draft.value, base: base.value })) {
      failure.value = 'The storage of this browser is full. Save before you close the page.';
    }
  });

  return {
    status: computed(() => {
      if (draft.value) return isReadonly.value ? 'readonly' : 'ready';
      if (!isKnown.value) return isReadonly.value ? 'readonly' : 'loading';
      return 'missing';
    }),
    draft,
    module,
    base,
    theirs,
    isGone,
    isChanged,
    problems,
    failure,
    isSaving,
    edit(change) {
      if (draft.value) draft.value = { ...draft.value, ...change };
    },
    discard() {
      if (base.value) take(base.value);
    },
    takeTheirs() {
      if (theirs.value) take(theirs.value);
    },
    keepMine() {
      refused.value = theirs.value;
      base.value = theirs.value ?? base.value;
      theirs.value = undefined;
    },
    async save() {
      const mine = draft.value;
      if (!mine || [...problems.value.keys()].some(isFatalProblem)) return undefined;
      return attempt(async () => {
        const before = base.value?.name;
        const saved = await client.call('processingModuleDatabaseSave', moduleOf(mine));
        if (before !== undefined && before !== saved.name && !isGone.value) {
          await client.call('processingModuleDatabaseDelete', { name: before });
        }
        const stored = draftOf(saved);
        base.value = stored;
        theirs.value = undefined;
        isGone.value = false;
        // Keep changes made during the save.
        if (draft.value && isSameDraft(draft.value, mine))
          draft.value = { ...stored, code: mine.code };
        dropDraft(address());
        return saved;
      });
    },
  };
}
