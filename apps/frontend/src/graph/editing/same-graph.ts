import type { Graph } from '../model/graph.ts';

/** True when nothing differs: steps share what they leave alone, so that identity tells. */
export function isSameGraph(a: Graph, b: Graph): boolean {
  return a.details === b.details && isSameMap(a.nodes, b.nodes) && isSameMap(a.wires, b.wires);
}

function isSameMap<T>(a: ReadonlyMap<string, T>, b: ReadonlyMap<string, T>): boolean {
  if (a === b) return true;
  if (a.size !== b.size) return false;
  for (const [key, value] of a) if (b.get(key) !== value) return false;
  return true;
}
