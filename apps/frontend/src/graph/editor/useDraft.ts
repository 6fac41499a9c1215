import { useDebounceFn, useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';
import { randomUuid } from '../../connection/random-uuid.ts';
import { graphNews } from '../model/changes/graph-news.ts';
import { graphOf } from '../model/graph-of.ts';
import type { Graph } from '../model/graph.ts';
import { withIds } from '../model/with-ids.ts';
import { findDraft, removeDraft, saveDraft, type Draft } from '../model/changes/draft.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';

/** Unsaved changes, stored in this browser until they are saved. */
export interface Drafts {
  /** Draft that was stored when the page was opened. */
  readonly found: Readonly<ShallowRef<Draft | undefined>>;
  /** True when the browser's storage is full: leaving the page would lose the changes. */
  readonly isFull: Readonly<ShallowRef<boolean>>;
  /** Stores the changes now. */
  keep(): void;
  /** Restores the draft that was found. */
  take(): void;
  discard(): void;
  /** Discards the draft of a session whose changes are stored elsewhere. */
  forget(sessionId: string): void;
  /** Stores nothing until `resume`. */
  pause(): void;
  resume(): void;
}

const KEEP_MS = 400;

/** Whether a graph contains all changes of a draft. */
const isSaved = ({ edited }: Draft, graph: Graph): boolean =>
  graphNews(graphOf(withIds(edited, randomUuid)), graph).length === 0;

export function useDraft(editor: GraphEditor): Drafts {
  const { id: sessionId } = editor.session.value;
  const found = shallowRef(findDraft(localStorage, sessionId));
  const isFull = shallowRef(false);
  let isPaused = false;
  // After a reload during a save, the draft equals what the master receives or already has.
  if (found.value !== undefined) editor.expect(found.value.edited);
  watch(
    editor.session,
    () => {
      if (found.value !== undefined && isSaved(found.value, editor.graph.value)) discard();
    },
    { immediate: true },
  );

  function keep(): void {
    // The found draft stays until the user restores or discards it.
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
  // Leaving the page would lose the changes: the browser asks for confirmation.
  useEventListener(window, 'beforeunload', (event: BeforeUnloadEvent) => {
    if (isFull.value && editor.changes.value > 0) event.preventDefault();
  });
  onScopeDispose(keep);

  function discard(): void {
    found.value = undefined;
    removeDraft(localStorage, sessionId);
  }

  function take(): void {
    const draft = found.value;
    found.value = undefined;
    if (draft !== undefined) editor.resume(draft.base, draft.edited);
  }

  return {
    found,
    isFull,
    keep,
    take,
    discard,
    forget(id) {
      removeDraft(localStorage, id);
      if (id === sessionId) isPaused = true;
    },
    pause: () => (isPaused = true),
    resume: () => (isPaused = false),
  };
}
