import { inject, type InjectionKey } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { LiveGraph } from './live-graph.ts';
import type { OwnPad } from './own-pad.ts';

/** State shared by the parts of the editor. */
export interface GraphContext {
  readonly editor: GraphEditor;
  readonly live: LiveGraph;
  readonly pad: OwnPad;
  /** Saves all changes; a running session continues with them. */
  apply(): void;
}

export const GRAPH_CONTEXT: InjectionKey<GraphContext> = Symbol('graph');

export function useGraphContext(): GraphContext {
  const context = inject(GRAPH_CONTEXT);
  if (!context) throw new Error('This part needs the graph page above it.');
  return context;
}
