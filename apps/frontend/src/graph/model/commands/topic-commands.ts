import type { Graph, GraphNode, TopicNode, Wire } from '../graph.ts';
import { topicNode, topicNodeId } from '../make-node.ts';
import { wiresOf } from '../wires-of.ts';
import type { CommandOf } from './graph-command.ts';
import type { GraphEdit } from './graph-edit.ts';
import { plainWire, revealTopic, viaWires } from './reveal-topic.ts';

/** Reroutes the wires of topics that are about to get nodes. */
export function placeTopics(edit: GraphEdit, nodes: readonly GraphNode[]): void {
  for (const node of nodes) {
    if (node.kind === 'topic' && !edit.graph.nodes.has(node.id)) {
      if (viaWires(edit.graph, node.topic).length === 0) continue;
      revealTopic(edit, node.topic, node.position);
    }
  }
}

/** Reconnects all wires of a topic to another topic, whose node is used if there is one. */
export function renameTopic(edit: GraphEdit, { node, topic }: CommandOf<'renameTopic'>): void {
  const old = edit.graph.nodes.get(node);
  if (old?.kind !== 'topic' || topic === '' || topic === old.topic) return;
  const id = topicNodeId(topic);
  const wires = wiresOf(edit.graph, node);
  if (viaWires(edit.graph, topic).length > 0) revealTopic(edit, topic, old.position);
  edit.removeNodes([node]);
  // Drop the format: it belongs to the old topic.
  if (!edit.graph.nodes.has(id)) edit.putNodes([topicNode(topic, { ...old, format: undefined })]);
  edit.putWires([
    ...wires.in.map(({ from, to, points }) => ({
      ...plainWire(from, { ...to, node: id }),
      points,
    })),
    ...wires.out.map(({ from, to, points }) => ({
      ...plainWire({ ...from, node: id }, to),
      points,
    })),
  ]);
}

export function setVia(edit: GraphEdit, { wire, topic }: CommandOf<'setVia'>): void {
  const old = edit.graph.wires.get(wire);
  if (old?.via === undefined || topic === '' || topic === old.via) return;
  const wires = viaWires(edit.graph, old.via);
  const isTaken =
    edit.graph.nodes.has(topicNodeId(topic)) || viaWires(edit.graph, topic).length > 0;
  edit.putWires(wires.map((one) => ({ ...one, via: topic })));
  if (isTaken) revealTopic(edit, topic);
}

export function showTopic(edit: GraphEdit, { wire, position }: CommandOf<'showTopic'>): void {
  const via = edit.graph.wires.get(wire)?.via;
  if (via !== undefined) revealTopic(edit, via, position);
}

/** True when a topic node can be replaced by wires between modules. */
export function canHide(graph: Graph, node: GraphNode): node is TopicNode {
  return node.kind === 'topic' && onlyWriter(graph, node) !== undefined;
}

function onlyWriter(graph: Graph, node: TopicNode): Wire | undefined {
  const { in: incoming, out } = wiresOf(graph, node.id);
  return incoming.length === 1 && out.length > 0 ? incoming[0] : undefined;
}

export function hideTopic(edit: GraphEdit, { node }: CommandOf<'hideTopic'>): void {
  const old = edit.graph.nodes.get(node);
  const writer = old?.kind === 'topic' ? onlyWriter(edit.graph, old) : undefined;
  if (old?.kind !== 'topic' || writer === undefined) return;
  const { out } = wiresOf(edit.graph, node);
  edit.removeNodes([node]);
  edit.putWires(out.map(({ to }) => plainWire(writer.from, to, old.topic)));
}
