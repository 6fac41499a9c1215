import type { Graph, NodeKind, PortRef, Wire } from '../graph.ts';
import { wireId } from '../graph.ts';
import { topicNodeId } from '../make-node.ts';
import { OUT, IN, ioName } from '../ports.ts';
import { portOf } from '../port-format.ts';
import { wiresAt } from '../wires-of.ts';
import { setConstant } from './edit-node.ts';
import { freeTopic } from './free-topic.ts';
import type { CommandOf } from './graph-command.ts';
import type { GraphEdit } from './graph-edit.ts';
import { revealTopic, viaWires } from './reveal-topic.ts';

/** Pairs of node kinds that a wire can connect, independent of data formats. */
const LEGAL: ReadonlySet<string> = new Set<`${NodeKind} ${NodeKind}`>([
  'topic module',
  'muxer module',
  'constant module',
  'module module',
  'module topic',
  'module demuxer',
]);

/** True when a session can represent the wire: one end is a module. */
export function isLegal(graph: Graph, from: PortRef, to: PortRef): boolean {
  const source = graph.nodes.get(from.node);
  const target = graph.nodes.get(to.node);
  if (source === undefined || target === undefined) return false;
  return (
    portOf(graph, from)?.direction === 'out' &&
    portOf(graph, to)?.direction === 'in' &&
    LEGAL.has(`${source.kind} ${target.kind}`)
  );
}

export function connect(edit: GraphEdit, { from, to, via }: CommandOf<'connect'>): void {
  const { graph } = edit;
  if (!isLegal(graph, from, to)) return;
  const isBetweenModules =
    graph.nodes.get(from.node)?.kind === 'module' && graph.nodes.get(to.node)?.kind === 'module';
  if (isBetweenModules) connectModules(edit, from, to, via);
  else putWire(edit, from, to);
}

function connectModules(
  edit: GraphEdit,
  from: PortRef,
  to: PortRef,
  wished: string | undefined,
): void {
  const written = writtenTopics(edit.graph, from);
  const topic = wished ?? written[0] ?? freeTopic(edit.graph, from, edit.elsewhere.used);
  const isWrittenByOthers = viaWires(edit.graph, topic).some(
    (wire) => wire.from.node !== from.node || wire.from.port !== from.port,
  );
  if (isWrittenByOthers) revealTopic(edit, topic);
  const node = topicNodeId(topic);
  if (!edit.graph.nodes.has(node)) {
    putWire(edit, from, to, topic);
    return;
  }
  putWire(edit, from, { node, port: IN });
  putWire(edit, { node, port: OUT }, to);
}

/** Topics that an output writes to: those without a node first. */
export function writtenTopics(graph: Graph, from: PortRef): string[] {
  const wires = wiresAt(graph, from);
  const hidden = wires.flatMap(({ via }) => via ?? []);
  const shown = wires.flatMap(({ to }) => {
    const node = graph.nodes.get(to.node);
    return node?.kind === 'topic' ? [node.topic] : [];
  });
  return [...hidden, ...shown];
}

/** Adds a wire to an input, which takes only one, and removes the previous one. */
export function putWire(edit: GraphEdit, from: PortRef, to: PortRef, via?: string): void {
  const id = wireId(from, to);
  const old = edit.graph.wires.get(id);
  if (old !== undefined && old.via === via) return;
  if (edit.graph.nodes.get(to.node)?.kind === 'module') {
    const others = wiresAt(edit.graph, to).filter((wire) => wire.id !== id);
    edit.removeWires(others.map((wire) => wire.id));
  }
  const wire: Wire = { id, from, to, via, points: old?.points ?? [] };
  edit.putWires([wire]);
  replaceValue(edit, wire);
}

/** A constant node wired to an input replaces the value set there. */
export function replaceValue(edit: GraphEdit, { from, to }: Wire): void {
  if (edit.graph.nodes.get(from.node)?.kind !== 'constant') return;
  setConstant(edit, {
    kind: 'setConstant',
    node: to.node,
    input: ioName(to.port),
    json: undefined,
  });
}
