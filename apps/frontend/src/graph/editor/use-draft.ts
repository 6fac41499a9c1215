import { useDebounceFn, useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';
import { findDraft, removeDraft, saveDraft, type Draft } from '../model/changes/draft.ts';
import type { GraphEditor } from './graph-editor.ts';

/** Changes that were not saved, kept in this browser until they are. */
export interface Drafts {
  /** Found when the page was opened. */
  readonly found: Readonly<ShallowRef<Draft | undefined>>;
  /** There is no room to keep changes: leaving the page would lose them. */
  readonly isFull: Readonly<ShallowRef<boolean>>;
  /** Writes the changes down now. */
  keep(): void;
  /** Goes on with what was found. */
  take(): void;
  discard(): void;
}

const KEEP_MS = 400;

export function useDraft(editor: GraphEditor): Drafts {
  const { id: sessionId } = editor.session.value;
  const found = shallowRef(findDraft(localStorage, sessionId));
  const isFull = shallowRef(false);

  function keep(): void {
    // What was found waits for an answer.
    if (found.value !== undefined) return;
    if (editor.changes.value === 0) {
      removeDraft(localStorage, sessionId);
      return;
    }
    const base = editor.baseSession();
    const revision = base.extension?.revision ?? 0;
    const draft = { sessionId, revision, base, edited: editor.toSession(), savedMs: Date.now() };
    isFull.value = !saveDraft(localStorage, draft);
  }
  const keepSoon = useDebounceFn(keep, KEEP_MS);
  watch([editor.graph, editor.changes], () => void keepSoon());
  useEventListener(window, 'pagehide', keep);
  onScopeDispose(keep);

  return {
    found,
    isFull,
    keep,
    take() {
      const draft = found.value;
      found.value = undefined;
      if (draft !== undefined) editor.resume(draft.base, draft.edited);
    },
    discard() {
      found.value = undefined;
      removeDraft(localStorage, sessionId);
    },
  };
}
