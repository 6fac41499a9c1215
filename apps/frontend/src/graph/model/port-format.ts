import type { DataFormat } from '@ubii/proto';
import type { Graph, Port, PortRef } from './graph.ts';
import { wiresOf } from './wires-of.ts';

/** Returns a port of a node; undefined when it does not exist. */
export function portOf(graph: Graph, { node, port }: PortRef): Port | undefined {
  return graph.nodes.get(node)?.ports.find(({ id }) => id === port);
}

/**
 * Returns the data format at a port. Topics and muxers without a known format take that of connected modules, writers
 * first.
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
