import { nodeTitle } from '../nodes/node-label.ts';
import { topicOfWire } from '../live/topics-in-graph.ts';
import type { Graph, GraphNode, PortRef, Wire } from '../model/graph.ts';
import { portOf } from '../model/port-format.ts';

/** Returns the other end of a wire: the topic, or the module with its port. */
export function farEnd(graph: Graph, wire: Wire, own: PortRef): string {
  const { node, port } = far(graph, wire, own);
  if (node === undefined) return '';
  if (node.kind === 'topic') return topicOfWire(graph, wire) ?? node.topic;
  return [nodeTitle(node), portOf(graph, port)?.name].filter(Boolean).join(' · ');
}

/** Returns the topic at the other end of a wire; undefined when it is no topic. */
export function farTopic(graph: Graph, wire: Wire, own: PortRef): string | undefined {
  return far(graph, wire, own).node?.kind === 'topic' ? farEnd(graph, wire, own) : undefined;
}

function far(
  graph: Graph,
  wire: Wire,
  own: PortRef,
): { readonly node: GraphNode | undefined; readonly port: PortRef } {
  const isInput = wire.to.node === own.node && wire.to.port === own.port;
  const port = isInput ? wire.from : wire.to;
  return { node: graph.nodes.get(port.node), port };
}
