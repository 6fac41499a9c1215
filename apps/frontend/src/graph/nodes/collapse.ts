import type { CommandOf } from '../model/commands/graph-command.ts';
import type { GraphNode } from '../model/graph.ts';

/** Kinds of nodes that can be collapsed. */
const KINDS: ReadonlySet<GraphNode['kind']> = new Set(['module', 'muxer', 'demuxer']);

export const canCollapse = ({ kind }: GraphNode): boolean => KINDS.has(kind);

/** Collapses nodes to their headers; expands them if all are collapsed. Undefined when none can be collapsed. */
export function collapseCommand(nodes: Iterable<GraphNode>): CommandOf<'collapse'> | undefined {
  const able = [...nodes].filter(canCollapse);
  if (able.length === 0) return undefined;
  const isCollapsed = !able.every((node) => node.isCollapsed);
  return { kind: 'collapse', nodes: able.map(({ id }) => id), isCollapsed };
}
