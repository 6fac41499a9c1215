import { nodeName } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import { fitOf } from '../fit/fit-of.ts';
import type { Graph, PortRef, Wire } from '../graph.ts';
import { wiresOf } from '../wires-of.ts';

/** Wire that replaces a path through removed nodes. */
interface Reconnection {
  readonly from: PortRef;
  readonly to: PortRef;
  readonly via: string | undefined;
}

/** Removes nodes, and connects their sources to their targets where they fit. */
export function removeAndReconnect(graph: Graph, ids: readonly string[]): GraphCommand {
  const gone = new Set(ids.filter((id) => graph.nodes.has(id)));
  return {
    kind: 'all',
    label: `Delete ${words(graph, [...gone])} and reconnect`,
    commands: [{ kind: 'remove', nodes: [...gone] }, ...connects(reconnections(graph, gone))],
  };
}

/** Disconnects nodes, and connects their sources to their targets where they fit. */
export function detach(graph: Graph, ids: readonly string[]): GraphCommand {
  const free = new Set(ids.filter((id) => graph.nodes.has(id)));
  const wires = [...free].flatMap((id) => {
    const { in: incoming, out } = wiresOf(graph, id);
    return [...incoming, ...out].filter(
      ({ from, to }) => !free.has(from.node) || !free.has(to.node),
    );
  });
  return {
    kind: 'all',
    label: `Detach ${words(graph, [...free])}`,
    commands: [
      { kind: 'remove', wires: [...new Set(wires.map(({ id }) => id))] },
      ...connects(reconnections(graph, free)),
    ],
  };
}

const connects = (list: readonly Reconnection[]): GraphCommand[] =>
  list.map(({ from, to, via }) => ({
    kind: 'connect',
    from,
    to,
    ...(via !== undefined && { via }),
  }));

function words(graph: Graph, ids: readonly string[]): string {
  const [only = ''] = ids;
  return ids.length === 1 ? nodeName(graph.nodes.get(only)) : `${ids.length} nodes`;
}

/** Returns the wires that replace paths through removed nodes. */
export function reconnections(graph: Graph, gone: ReadonlySet<string>): Reconnection[] {
  const found: Reconnection[] = [];
  for (const id of gone) {
    for (const { from, to } of wiresOf(graph, id).out) {
      if (gone.has(to.node)) continue;
      const source = findSource(graph, gone, from, to, new Set());
      if (source !== undefined) found.push({ ...source, to });
    }
  }
  return found;
}

/** Returns the nearest output before the removed nodes that fits the input. */
function findSource(
  graph: Graph,
  gone: ReadonlySet<string>,
  { node: id }: PortRef,
  to: PortRef,
  visited: Set<string>,
): Omit<Reconnection, 'to'> | undefined {
  if (visited.has(id)) return undefined;
  visited.add(id);
  const node = graph.nodes.get(id);
  // Values stay on their topic; a removed topic node passes its topic to the wires.
  const topic = node?.kind === 'topic' ? node.topic : undefined;
  for (const { from, via = topic } of feeding(graph, id)) {
    if (gone.has(from.node)) {
      const source = findSource(graph, gone, from, to, visited);
      if (source !== undefined) return source;
    } else if (fitOf(graph, from, to).fits) return { from, via };
  }
  return undefined;
}

/** Returns the wires into a node, that of its main (first) input first; without constants, which are parameters. */
export function feeding(graph: Graph, id: string): Wire[] {
  const order = new Map(graph.nodes.get(id)?.ports.map((port, index) => [port.id, index]));
  return wiresOf(graph, id)
    .in.filter(({ from }) => graph.nodes.get(from.node)?.kind !== 'constant')
    .sort((a, b) => (order.get(a.to.port) ?? 0) - (order.get(b.to.port) ?? 0));
}
