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
  /** Changes of a session are somewhere else now. */
  forget(sessionId: string): void;
  /** Writes nothing more down, until `resume`: what is there belongs to somebody else. */
  pause(): void;
  resume(): void;
}

const KEEP_MS = 400;

/** Put into the state of the history by who leads here in the middle of the work. */
export interface GoOn {
  readonly goOn: true;
  /** Saving was asked for, and could not be done yet. */
  readonly save: boolean;
}

/** What was put there. */
export function goOnHere(): GoOn | undefined {
  const { state } = history as { readonly state: Partial<GoOn> | null };
  return state?.goOn === true ? { goOn: true, save: state.save === true } : undefined;
}

export function useDraft(editor: GraphEditor): Drafts {
  const { id: sessionId } = editor.session.value;
  const found = shallowRef(findDraft(localStorage, sessionId));
  const isFull = shallowRef(false);
  let isPaused = false;

  function keep(): void {
    // What was found waits for an answer.
    if (found.value !== undefined || isPaused) return;
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
  // While nothing is kept, leaving loses it: the browser asks.
  useEventListener(window, 'beforeunload', (event: BeforeUnloadEvent) => {
    if (isFull.value && editor.changes.value > 0) event.preventDefault();
  });
  onScopeDispose(keep);

  function take(): void {
    const draft = found.value;
    found.value = undefined;
    if (draft !== undefined) editor.resume(draft.base, draft.edited);
  }
  if (goOnHere()) take();

  return {
    found,
    isFull,
    keep,
    take,
    discard() {
      found.value = undefined;
      removeDraft(localStorage, sessionId);
    },
    forget(id) {
      removeDraft(localStorage, id);
      if (id === sessionId) isPaused = true;
    },
    pause: () => (isPaused = true),
    resume: () => (isPaused = false),
  };
}
