import type { Graph, GraphNode, Port } from './graph.ts';
import { wiresAt } from './wires-of.ts';

/**
 * Returns the main (first) input of a module if it has no wire, no fixed value and no default. Further inputs without a
 * default may be optional.
 */
export function openInput(graph: Graph, node: GraphNode | undefined): Port | undefined {
  if (node?.kind !== 'module') return undefined;
  const main = node.ports.find(({ direction }) => direction === 'in');
  if (main === undefined || main.defaultJson !== undefined || node.constants.has(main.name))
    return undefined;
  return wiresAt(graph, { node: node.id, port: main.id }).length === 0 ? main : undefined;
}
