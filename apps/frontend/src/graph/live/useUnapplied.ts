import { computed, type ComputedRef } from 'vue';
import type { GraphNode } from '../model/graph.ts';
import { isUnapplied } from '../model/changes/unapplied-value.ts';
import { useGraphContext } from './useGraphContext.ts';

/**
 * True while the session runs with another value than the graph has, and the change waits for the user.
 *
 * @param input of a module; undefined: any of its inputs
 */
export function useUnapplied(node: () => GraphNode, input?: () => string): ComputedRef<boolean> {
  const { editor, pending } = useGraphContext();
  return computed(
    () => pending.waits.value && isUnapplied(editor.savedNode(node().id), node(), input?.()),
  );
}
