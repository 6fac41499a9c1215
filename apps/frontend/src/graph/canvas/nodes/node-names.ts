import { computed, inject, provide, type ComputedRef, type InjectionKey } from 'vue';
import { sortedNames, type SortedNames } from '../../../ui/names/distinct-part.ts';
import type { Graph } from '../../model/graph.ts';
import { nodeTitle } from '../../nodes/node-label.ts';

const NAMES: InjectionKey<ComputedRef<SortedNames>> = Symbol('names of nodes');
const NONE = computed((): SortedNames => []);

/** Provides the titles of all nodes to child views, so that shortened titles stay distinguishable. */
export function provideNodeNames(graph: () => Graph): void {
  const titles = computed<SortedNames>((before) => {
    const next = sortedNames([...graph().nodes.values()].map(nodeTitle));
    // Moving a node changes the graph, but no name: keep the same array.
    const isSame = before?.length === next.length && next.every((name, at) => name === before[at]);
    return isSame && before !== undefined ? before : next;
  });
  provide(NAMES, titles);
}

export const useNodeNames = (): ComputedRef<SortedNames> => inject(NAMES, NONE);
