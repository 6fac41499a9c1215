import { computed, type ComputedRef, type InjectionKey } from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { LiveGraph } from './live-graph.ts';
import type { OwnPad } from './own-pad.ts';

/** Changes that a running session does not have yet. */
export interface PendingChanges {
  /** Number of modules that restart with them. */
  readonly restarts: ComputedRef<number>;
  /** True when they wait for the user; others apply by themselves. */
  readonly waits: ComputedRef<boolean>;
}

/** For a graph that is not edited. */
export const NOTHING_PENDING: PendingChanges = {
  restarts: computed(() => 0),
  waits: computed(() => false),
};

/** State shared by the parts of the editor. */
export interface GraphContext {
  readonly editor: GraphEditor;
  readonly live: LiveGraph;
  readonly pad: OwnPad;
  readonly pending: PendingChanges;
  /** Saves all changes; a running session continues with them. */
  apply(): void;
}

export const GRAPH_CONTEXT: InjectionKey<GraphContext> = Symbol('graph');

export function useGraphContext(): GraphContext {
  return injectOrThrow(GRAPH_CONTEXT, 'the graph page above it');
}
