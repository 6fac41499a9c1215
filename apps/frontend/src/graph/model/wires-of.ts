import type { Graph, PortRef, Wire } from './graph.ts';

/** Wires of one node. */
export interface NodeWires {
  readonly in: readonly Wire[];
  readonly out: readonly Wire[];
}

const NONE: NodeWires = { in: [], out: [] };

/** Indices of wires by node, created on first use for each version of a graph. */
const INDICES = new WeakMap<Graph['wires'], ReadonlyMap<string, NodeWires>>();

/** Returns the wires into and out of a node, in the order of the graph. */
export function wiresOf(graph: Pick<Graph, 'wires'>, nodeId: string): NodeWires {
  let index = INDICES.get(graph.wires);
  if (index === undefined) {
    index = indexOf(graph.wires.values());
    INDICES.set(graph.wires, index);
  }
  return index.get(nodeId) ?? NONE;
}

/** Returns the wires at a port. */
export function wiresAt(graph: Pick<Graph, 'wires'>, { node, port }: PortRef): readonly Wire[] {
  const { in: incoming, out } = wiresOf(graph, node);
  return [
    ...incoming.filter((wire) => wire.to.port === port),
    ...out.filter((wire) => wire.from.port === port),
  ];
}

function indexOf(wires: Iterable<Wire>): ReadonlyMap<string, NodeWires> {
  const index = new Map<string, { in: Wire[]; out: Wire[] }>();
  const at = (id: string): { in: Wire[]; out: Wire[] } => {
    let entry = index.get(id);
    if (entry === undefined) index.set(id, (entry = { in: [], out: [] }));
    return entry;
  };
  for (const wire of wires) {
    at(wire.from.node).out.push(wire);
    at(wire.to.node).in.push(wire);
  }
  return index;
}
