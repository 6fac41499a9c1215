import { phoneTopicTags } from '../live/phone-topics.ts';
import type { Graph, GraphNode, Port } from '../model/graph.ts';
import { wiresAt } from '../model/wires-of.ts';

/** Returns the ports to list: all but the input of a topic that this browser's smart device writes. */
export function listedPorts(graph: Graph, node: GraphNode, ownId: string): readonly Port[] {
  if (node.kind !== 'topic' || phoneTopicTags(node.topic, ownId) === undefined) return node.ports;
  return node.ports.filter(
    ({ id, direction }) =>
      direction === 'out' || wiresAt(graph, { node: node.id, port: id }).length > 0,
  );
}
