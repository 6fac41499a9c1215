import { fromJson, toJson, type Session } from '@ubii/proto';
import { useDebounceFn, useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';
import type { GraphEditor } from './graph-editor.ts';

/** Changes that were not saved, kept in this browser until they are. */
export interface Draft {
  /** Found when the page was opened: a session with changes. */
  readonly found: Readonly<ShallowRef<Session | undefined>>;
  /** Writes the changes down now. */
  keep(): void;
  /** Shows what was found. */
  take(): void;
  discard(): void;
}

const KEEP_MS = 400;

export function useDraft(editor: GraphEditor): Draft {
  const key = `ubii.draft.${editor.session.value.id}`;
  const found = shallowRef(readDraft(key));

  function keep(): void {
    // What was found waits for an answer.
    if (found.value !== undefined) return;
    try {
      if (editor.changes.value === 0) localStorage.removeItem(key);
      else
        localStorage.setItem(
          key,
          JSON.stringify(toJson('ubii.sessions.Session', editor.toSession())),
        );
    } catch {
      // No room, or forbidden: the page works without.
    }
  }
  const keepSoon = useDebounceFn(keep, KEEP_MS);
  watch([editor.graph, editor.changes], () => void keepSoon());
  useEventListener(window, 'pagehide', keep);
  onScopeDispose(keep);

  return {
    found,
    keep,
    take() {
      const draft = found.value;
      found.value = undefined;
      if (draft !== undefined) editor.replace(draft);
    },
    discard() {
      found.value = undefined;
      localStorage.removeItem(key);
    },
  };
}

function readDraft(key: string): Session | undefined {
  try {
    const text = localStorage.getItem(key);
    return text === null ? undefined : fromJson('ubii.sessions.Session', JSON.parse(text));
  } catch {
    return undefined;
  }
}
