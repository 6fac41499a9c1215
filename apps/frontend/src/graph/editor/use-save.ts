import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { useSessionActions } from '../../sessions/actions/useSessionActions.ts';
import type { LifeAction } from '../../sessions/state/session-state.ts';
import type { GraphEditor } from './graph-editor.ts';

/** Brings changes to the master, and the session to life. */
export interface Saving {
  readonly isBusy: ComputedRef<boolean>;
  /** Why the last intent failed, one sentence. */
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  /** @returns whether the master has everything now */
  save(): Promise<boolean>;
  /** Saves what is not saved before anything starts. */
  act(action: LifeAction): Promise<void>;
}

export function useSave(editor: GraphEditor): Saving {
  const actions = useSessionActions();
  const isSaving = shallowRef(false);
  const failure = shallowRef<string>();

  async function save(): Promise<boolean> {
    if (editor.changes.value === 0) return true;
    const mark = editor.mark();
    isSaving.value = true;
    failure.value = undefined;
    try {
      const next = editor.toSession();
      const saved = await actions.calls.update(next, {});
      editor.handleSaved(saved, mark);
      return true;
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      failure.value = cause.message;
      return false;
    } finally {
      isSaving.value = false;
    }
  }

  return {
    isBusy: computed(() => isSaving.value || actions.busy.value.has(editor.session.value.id)),
    failure: computed(
      () => failure.value ?? actions.failures.value.get(editor.session.value.id),
    ) as Saving['failure'],
    save,
    async act(action) {
      const needsSaving = action === 'start' || action === 'restart' || action === 'resume';
      if (needsSaving && !(await save())) return;
      await actions.act(editor.session.value, action);
    },
  };
}
