import { parseDataFormat, type ProcessingModule } from '@ubii/proto';
import { portName } from '../commands/command-label.ts';
import { proposedTopic } from '../commands/free-topic.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, GraphNode, PortRef } from '../graph.ts';
import { moduleNode, topicNode } from '../make-node.ts';
import { portFormat } from '../port-format.ts';
import { OUT } from '../ports.ts';
import { newConstantNode, newDemuxerNode, newModuleNode, newMuxerNode } from '../new-node.ts';
import type { NewNodes } from './adapt.ts';
import { fitEnds } from './fit-of.ts';
import type { KnownTopic, NodeOffer } from './node-offer.ts';
import { rankOffers } from './rank-offers.ts';
import { endOf, type WireEnd } from './wire-end.ts';

/** Returns all ports that a wire from this port can end at; the others are dimmed. */
export function fittingPorts(graph: Graph, ref: PortRef): PortRef[] {
  const own = endOf(graph, ref);
  if (own === undefined) return [];
  const fitting: PortRef[] = [];
  for (const node of graph.nodes.values()) {
    for (const { id, direction } of node.ports) {
      if (direction === own.port.direction) continue;
      const end = endOf(graph, { node: node.id, port: id });
      if (end !== undefined && fitEnds(graph, own, end).fits) fitting.push(end.ref);
    }
  }
  return fitting;
}

/**
 * Returns the nodes that a wire dropped on empty canvas can lead to, best first; modules with their first fitting port.
 * [SE-70]
 * @param topics topics with a publisher; topics of the graph are offered, too
 * @param used topics that others use, which no new topic is named after
 */
export function fittingNodes(
  graph: Graph,
  ref: PortRef,
  library: readonly ProcessingModule[],
  topics: readonly KnownTopic[],
  used?: ReadonlySet<string>,
): NodeOffer[] {
  const own = endOf(graph, ref);
  if (own === undefined) return [];
  const offers = [
    ...plainOffers(graph, own, used),
    ...library.flatMap((module) => moduleOffer(graph, own, module) ?? []),
    ...topicsToOffer(graph, topics).flatMap((topic) => topicOffer(graph, own, topic) ?? []),
  ];
  return rankOffers(graph, ref, offers, topics);
}

/** Topics of the graph come first: they belong to the session. */
function topicsToOffer(graph: Graph, topics: readonly KnownTopic[]): KnownTopic[] {
  const all = new Map<string, KnownTopic>();
  for (const node of graph.nodes.values()) {
    if (node.kind !== 'topic') continue;
    const format = portFormat(graph, { node: node.id, port: OUT }) ?? '';
    all.set(node.topic, { topic: node.topic, format });
  }
  for (const known of topics) {
    if (known.format !== '' || !all.has(known.topic)) all.set(known.topic, known);
  }
  return [...all.values()];
}

function plainOffers(graph: Graph, own: WireEnd, used?: ReadonlySet<string>): NodeOffer[] {
  if (own.node.kind !== 'module') return [];
  const { port, format } = own;
  const dataType = format ?? '';
  if (port.direction === 'out') {
    const topic = proposedTopic(graph, own.ref, used);
    const isNewTopic = fitsNode(graph, own, topicNode(topic)) !== undefined;
    return [
      ...(isNewTopic ? [{ kind: 'topic', label: topic, topic, isNew: true, format } as const] : []),
      ...(port.isList ? [{ kind: 'demuxer', label: 'Demuxer', dataType } as const] : []),
    ];
  }
  if (port.isList) return [{ kind: 'muxer', label: 'Muxer', dataType }];
  return format === undefined ? [] : [{ kind: 'constant', label: 'Constant', format }];
}

function moduleOffer(graph: Graph, own: WireEnd, module: ProcessingModule): NodeOffer | undefined {
  const port = fitsNode(graph, own, moduleNode(module));
  if (port === undefined) return undefined;
  return { kind: 'module', label: module.name, module, port };
}

function topicOffer(graph: Graph, own: WireEnd, known: KnownTopic): NodeOffer | undefined {
  const { topic } = known;
  const format = parseDataFormat(known.format);
  if (own.node.kind === 'topic' || own.node.id === topicNode(topic).id) return undefined;
  if (fitsNode(graph, own, topicNode(topic, { format })) === undefined) return undefined;
  return { kind: 'topic', label: topic, topic, isNew: false, format };
}

/** Returns the first port of a node that the wire fits; the node need not be in the graph. */
export function fitsNode(graph: Graph, own: WireEnd, node: GraphNode): string | undefined {
  return node.ports.find((port) => {
    if (port.direction === own.port.direction) return false;
    const end: WireEnd = { ref: { node: node.id, port: port.id }, node, port, format: port.format };
    return fitEnds(graph, own, end).fits;
  })?.id;
}

/** Adds an offered node, wired to the start of the wire, as one step. */
export function offerCommand(
  graph: Graph,
  ref: PortRef,
  offer: NodeOffer,
  { uuid, position }: NewNodes,
): GraphCommand {
  const node = offeredNode(offer, uuid, position);
  const own = endOf(graph, ref);
  const isThere = graph.nodes.has(node.id);
  const port = offer.kind === 'module' ? offer.port : own && fitsNode(graph, own, node);
  const other = { node: node.id, port: port ?? '' };
  const [from, to] = own?.port.direction === 'in' ? [other, ref] : [ref, other];
  return {
    kind: 'all',
    label: `Connect ${portName(graph, ref)} to ${offer.label}`,
    commands: [
      { kind: 'add', nodes: isThere ? [] : [node] },
      { kind: 'connect', from, to },
    ],
  };
}

function offeredNode(
  offer: NodeOffer,
  uuid: () => string,
  position: NewNodes['position'],
): GraphNode {
  const look = { position };
  switch (offer.kind) {
    case 'module':
      return newModuleNode(offer.module, uuid(), look);
    case 'topic':
      return topicNode(offer.topic, { ...look, format: offer.format });
    case 'muxer':
      return newMuxerNode(uuid(), { dataType: offer.dataType }, look);
    case 'demuxer':
      return newDemuxerNode(uuid(), { dataType: offer.dataType }, look);
    case 'constant':
      return newConstantNode(uuid(), offer.format, look);
  }
}
