import type { Graph } from '../graph.ts';
import { wiresOf } from '../wires-of.ts';

/** Cycle of modules, with the wires between them. */
export interface Cycle {
  /** Ids of module nodes. */
  readonly nodes: readonly string[];
  readonly wires: readonly string[];
}

/** Returns the cycles of modules in a graph, direct or through topics (Tarjan 1972, without recursion). */
export function cyclesIn(graph: Graph): Cycle[] {
  const order = new Map<string, number>();
  const low = new Map<string, number>();
  const open: string[] = [];
  const isOpen = new Set<string>();
  const parts: string[][] = [];
  for (const root of graph.nodes.keys()) {
    if (order.has(root)) continue;
    const work = [enter(root)];
    while (work.length > 0) {
      const { id, next } = work.at(-1)!;
      const step = next.next();
      if (!step.done) {
        const other = step.value.to.node;
        if (!order.has(other)) work.push(enter(other));
        else if (isOpen.has(other)) low.set(id, Math.min(low.get(id)!, order.get(other)!));
        continue;
      }
      work.pop();
      const above = work.at(-1)?.id;
      if (above !== undefined) low.set(above, Math.min(low.get(above)!, low.get(id)!));
      if (low.get(id) !== order.get(id)) continue;
      const part = open.splice(open.indexOf(id));
      for (const one of part) isOpen.delete(one);
      parts.push(part);
    }
  }
  return parts.flatMap((part) => cycleOf(graph, part) ?? []);

  function enter(id: string) {
    order.set(id, order.size);
    low.set(id, order.get(id)!);
    open.push(id);
    isOpen.add(id);
    return { id, next: wiresOf(graph, id).out.values() };
  }
}

function cycleOf(graph: Graph, part: readonly string[]): Cycle | undefined {
  const within = new Set(part);
  const wires = part.flatMap((id) =>
    wiresOf(graph, id).out.flatMap(({ to, id: wire }) => (within.has(to.node) ? [wire] : [])),
  );
  if (wires.length === 0) return undefined;
  const nodes = part.filter((id) => graph.nodes.get(id)?.kind === 'module');
  return nodes.length === 0 ? undefined : { nodes, wires };
}
