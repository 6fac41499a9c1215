import type { Graph, PortRef, TopicNode, Wire } from '../graph.ts';
import { topicNodeId } from '../make-node.ts';
import { ioName } from '../ports.ts';
import { wiresOf } from '../wires-of.ts';
import {
  freeTopic,
  proposedTopic,
  sessionPart,
  topicPart,
  topicsOf,
  unusedTopic,
} from './free-topic.ts';
import type { CommandOf } from './graph-command.ts';
import type { GraphEdit } from './graph-edit.ts';
import { viaWires } from './reveal-topic.ts';
import { renameTopic } from './topic-commands.ts';

/** Gives topics of this session to new wires between modules whose topic others use. */
export function withOwnTopics(edit: GraphEdit, wires: readonly Wire[]): readonly Wire[] {
  const topics = new Map<string, string>();
  const used = new Set<string>();
  return wires.map((wire) => {
    const { via } = wire;
    if (via === undefined || !edit.elsewhere.used.has(via) || topicsOf(edit.graph).has(via)) {
      return wire;
    }
    const taken = new Set([...used, ...edit.elsewhere.used]);
    const topic = topics.get(via) ?? freeTopic(edit.graph, wire.from, taken);
    topics.set(via, topic);
    used.add(topic);
    return { ...wire, via: topic };
  });
}

/**
 * Renames the topics that the editor made or proposed for outputs after a new name of the session. Topics that a user
 * named, that others read or that a muxer of the session may select stay.
 * @param before the previous name
 */
export function followName(edit: GraphEdit, before: string): void {
  const [old, now] = [sessionPart(before), sessionPart(edit.graph.details.name)];
  if (old === now || isSelected(edit.graph, old)) return;
  for (const [topic, from] of madeTopics(edit.graph, old)) {
    if (!edit.elsewhere.needed.has(topic)) renameWires(edit, topic, from);
  }
  for (const { node, from } of proposedTopics(edit.graph, old)) {
    if (edit.elsewhere.needed.has(node.topic)) continue;
    const isShort = node.topic.split('/').length === SHORT_LEVELS;
    const nameTopic = isShort ? proposedTopic : freeTopic;
    const topic = nameTopic(edit.graph, from, edit.elsewhere.used);
    renameTopic(edit, { kind: 'renameTopic', node: node.id, topic });
  }
}

/** Of `/session/output`, with the empty one before the first slash. */
const SHORT_LEVELS = 3;

/** Nodes of topics with the name that the editor proposes, with the output that writes each. */
function proposedTopics(graph: Graph, session: string): { node: TopicNode; from: PortRef }[] {
  return [...graph.nodes.values()].flatMap((node) => {
    if (node.kind !== 'topic') return [];
    const [wire, ...others] = wiresOf(graph, node.id).in;
    if (wire === undefined || others.length > 0) return [];
    const [, first, ...rest] = node.topic.split('/');
    const isNamed = rest.length <= 2 && isOfOutput(rest.at(-1) ?? '', wire.from);
    return first === session && isNamed ? [{ node, from: wire.from }] : [];
  });
}

/** Whether the last level of a topic is that of an output, with or without a number. */
function isOfOutput(last: string, { port }: PortRef): boolean {
  const io = topicPart(ioName(port));
  return last === io || (last.startsWith(`${io}-`) && /^\d+$/.test(last.slice(io.length + 1)));
}

/** Topics of wires with the name that the editor gives, with the output that writes each. */
function madeTopics(graph: Graph, session: string): Map<string, PortRef> {
  const made = new Map<string, PortRef>();
  for (const { via, from } of graph.wires.values()) {
    if (via === undefined) continue;
    const [, first, , last = '', ...more] = via.split('/');
    if (first === session && isOfOutput(last, from) && more.length === 0) made.set(via, from);
  }
  return made;
}

/** Whether a muxer of the graph may select topics of a session. */
function isSelected(graph: Graph, session: string): boolean {
  return [...graph.nodes.values()].some((node) => {
    if (node.kind !== 'muxer') return false;
    const { topicGlob, topicSelector } = node.mux;
    return [topicGlob, topicSelector].some((pattern) => pattern.includes(session));
  });
}

function renameWires(edit: GraphEdit, topic: string, from: PortRef): void {
  const via = freeTopic(edit.graph, from, edit.elsewhere.used);
  edit.putWires(viaWires(edit.graph, topic).map((wire) => ({ ...wire, via })));
}

export function ownTopics(edit: GraphEdit, { topics }: CommandOf<'ownTopics'>): void {
  for (const topic of topics) {
    const [wire] = viaWires(edit.graph, topic);
    if (wire !== undefined) renameWires(edit, topic, wire.from);
    const node = topicNodeId(topic);
    // A topic that this session only reads belongs to the other one.
    if (wiresOf(edit.graph, node).in.length === 0) continue;
    const last = topicPart(topic.slice(topic.lastIndexOf('/') + 1));
    const wished = `/${sessionPart(edit.graph.details.name)}/${last}`;
    const taken = new Set([...topicsOf(edit.graph), ...edit.elsewhere.used]);
    renameTopic(edit, { kind: 'renameTopic', node, topic: unusedTopic(taken, wished) });
  }
}
