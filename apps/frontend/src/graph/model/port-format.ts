import type { DataFormat } from '@ubii/proto';
import type { Graph, Port, PortRef } from './graph.ts';
import { wiresOf } from './wires-of.ts';

/** A port of a node; undefined when it is not there. */
export function portOf(graph: Graph, { node, port }: PortRef): Port | undefined {
  return graph.nodes.get(node)?.ports.find(({ id }) => id === port);
}

/**
 * The data format at a port; where the node does not know it, as topics and muxers may not, that of
 * the modules it is wired to, writers first.
 */
export function portFormat(graph: Graph, ref: PortRef): DataFormat | undefined {
  const node = graph.nodes.get(ref.node);
  const own = node?.ports.find(({ id }) => id === ref.port)?.format;
  if (own !== undefined || node === undefined || node.kind === 'module') return own;
  const wires = wiresOf(graph, ref.node);
  for (const end of [...wires.in.map(({ from }) => from), ...wires.out.map(({ to }) => to)]) {
    const format = portOf(graph, end)?.format;
    if (format !== undefined) return format;
  }
  return undefined;
}
