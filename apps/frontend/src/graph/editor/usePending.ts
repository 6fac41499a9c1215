import { useDebounceFn } from '@vueuse/core';
import { computed, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { PendingChanges } from '../live/useGraphContext.ts';
import { changesBetween } from '../model/changes/changes-between.ts';
import type { Graph } from '../model/graph.ts';
import type { Saving } from './useSave.ts';

/** Delay after the last change, milliseconds: a drag and a word are one change. */
const APPLY_MS = 300;

/**
 * Applies changes to a running session by themselves, unless they restart a module. [SE-15] Changes that the master
 * refused or that conflict with those of another client wait for the user.
 */
export function usePending(editor: GraphEditor, saving: Saving): PendingChanges {
  const { isConnected } = useConnection();
  const isOpen = computed(() => editor.changes.value > 0 && isAlive(editor.session.value));
  const restarts = computed(() => {
    if (!isOpen.value) return 0;
    const effects = changesBetween(editor.session.value, editor.toSession());
    return effects.filter(({ effect }) => effect === 'restart').length;
  });
  const isBlocked = computed(
    () => restarts.value > 0 || !isConnected.value || (editor.merged.value ?? []).length > 0,
  );
  /** Graph that was sent last. */
  let tried: Graph | undefined;
  const applySoon = useDebounceFn(() => {
    const isRefused = saving.isRefused.value && tried === editor.graph.value;
    if (!isOpen.value || isBlocked.value || isRefused) return;
    tried = editor.graph.value;
    void saving.save();
  }, APPLY_MS);
  watch([editor.graph, editor.session, isConnected], () => {
    if (isOpen.value) void applySoon();
  });
  return {
    restarts,
    waits: computed(() => isOpen.value && (isBlocked.value || saving.isRefused.value)),
  };
}
