import { nodeTitle } from '../canvas/node-label.ts';
import { topicOfWire } from '../live/topics-in-graph.ts';
import type { Graph, PortRef, Wire } from '../model/graph.ts';
import { portOf } from '../model/port-format.ts';

/** What is at the other end of a wire: the topic, or the module with its port. */
export function farEnd(graph: Graph, wire: Wire, own: PortRef): string {
  const isInput = wire.to.node === own.node && wire.to.port === own.port;
  const far = isInput ? wire.from : wire.to;
  const node = graph.nodes.get(far.node);
  if (node === undefined) return '';
  if (node.kind === 'topic') return topicOfWire(graph, wire) ?? node.topic;
  return [nodeTitle(node), portOf(graph, far)?.name].filter(Boolean).join(' · ');
}
