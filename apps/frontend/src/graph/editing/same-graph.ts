import type { Graph } from '../model/graph.ts';

/** True when two graphs are equal. Steps share the objects they do not change, so identity is compared. */
export function isSameGraph(a: Graph, b: Graph): boolean {
  return a.details === b.details && isSameMap(a.nodes, b.nodes) && isSameMap(a.wires, b.wires);
}

function isSameMap<T>(a: ReadonlyMap<string, T>, b: ReadonlyMap<string, T>): boolean {
  if (a === b) return true;
  if (a.size !== b.size) return false;
  for (const [key, value] of a) if (b.get(key) !== value) return false;
  return true;
}
