import type { DataFormat } from '@ubii/proto';
import type { Graph, GraphNode, Port, PortRef } from '../graph.ts';
import { portFormat, portOf } from '../port-format.ts';

/** One end of a requested wire. */
export interface WireEnd {
  readonly ref: PortRef;
  readonly node: GraphNode;
  readonly port: Port;
  readonly format: DataFormat | undefined;
}

/** Returns a port of a graph as the end of a wire. */
export function endOf(graph: Graph, ref: PortRef): WireEnd | undefined {
  const node = graph.nodes.get(ref.node);
  const port = portOf(graph, ref);
  if (node === undefined || port === undefined) return undefined;
  return { ref, node, port, format: portFormat(graph, ref) };
}
