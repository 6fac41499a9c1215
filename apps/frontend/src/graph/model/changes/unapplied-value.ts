import type { GraphNode } from '../graph.ts';

/**
 * True when a value of a node differs from what the master has of it. False for nodes that the master does not have yet.
 *
 * @param saved the node as the master has it
 * @param input name of an input with a constant, of a module
 */
export function isUnapplied(
  saved: GraphNode | undefined,
  node: GraphNode,
  input?: string,
): boolean {
  if (node.kind === 'constant') return saved?.kind === 'constant' && saved.json !== node.json;
  if (node.kind !== 'module' || saved?.kind !== 'module') return false;
  const names =
    input === undefined ? [...saved.constants.keys(), ...node.constants.keys()] : [input];
  return names.some((name) => saved.constants.get(name) !== node.constants.get(name));
}
