import type { Graph, PortRef } from '../graph.ts';
import { moduleNode, topicNodeId } from '../make-node.ts';
import { wiresOf } from '../wires-of.ts';
import type { KnownTopic, NodeOffer } from './node-offer.ts';
import { endOf, type WireEnd } from './wire-end.ts';

/** Rank of a connection; lower is better. [SE-70] */
const CLOSENESS = {
  sameFormat: 0,
  /** Conversion between number types. [PM-31] */
  converted: 1,
  unknownFormat: 2,
  /** A port of a module other than the first: parameters and by-products. */
  sidePort: 3,
} as const;
const GROUPS = { existing: 0, fresh: 1, module: 2, used: 3, unknown: 4 } as const;

/** Returns the rank of a wire to a fitting port; lower is better. */
export function closeness(own: WireEnd, { node, port, format }: Omit<WireEnd, 'ref'>): number {
  const main = node.ports.find(({ direction }) => direction === port.direction);
  return main?.id === port.id ? formatCloseness(own, format) : CLOSENESS.sidePort;
}

function formatCloseness(own: WireEnd, format: WireEnd['format']): number {
  if (own.format === undefined || own.format === format) return CLOSENESS.sameFormat;
  return format === undefined ? CLOSENESS.unknownFormat : CLOSENESS.converted;
}

/**
 * Sorts by rank, best first; stable. [SE-70]
 * @param published topics that have a publisher
 */
export function rankOffers(
  graph: Graph,
  ref: PortRef,
  offers: readonly NodeOffer[],
  published: readonly KnownTopic[],
): NodeOffer[] {
  const own = endOf(graph, ref);
  if (own === undefined) return [...offers];
  const isPublished = new Set(published.map(({ topic }) => topic));
  return offers
    .map((offer) => {
      const close = offerCloseness(own, offer);
      return { offer, close, group: groupOf(graph, own, offer, close, isPublished) };
    })
    .sort((a, b) => a.group - b.group || a.close - b.close)
    .map(({ offer }) => offer);
}

function offerCloseness(own: WireEnd, offer: NodeOffer): number {
  switch (offer.kind) {
    case 'module': {
      const node = moduleNode(offer.module);
      const port = node.ports.find(({ id }) => id === offer.port);
      if (port === undefined) return CLOSENESS.sidePort;
      return closeness(own, { node, port, format: port.format });
    }
    case 'topic':
      return offer.isNew ? CLOSENESS.sameFormat : formatCloseness(own, offer.format);
    default:
      return CLOSENESS.sameFormat;
  }
}

function groupOf(
  graph: Graph,
  own: WireEnd,
  offer: NodeOffer,
  close: number,
  isPublished: ReadonlySet<string>,
): number {
  if (offer.kind === 'module') return GROUPS.module;
  if (offer.kind !== 'topic' || offer.isNew) return GROUPS.fresh;
  if (close === CLOSENESS.unknownFormat) return GROUPS.unknown;
  if (own.port.direction === 'in') return GROUPS.existing;
  return isInUse(graph, own.node.id, offer.topic, isPublished) ? GROUPS.used : GROUPS.existing;
}

/** Values of two publishers would mix, and a module that reads the topic would feed itself. */
export function isInUse(
  graph: Graph,
  writer: string,
  topic: string,
  isPublished: ReadonlySet<string>,
): boolean {
  const wires = wiresOf(graph, topicNodeId(topic));
  const isRead = wires.out.some(({ to }) => to.node === writer);
  return isPublished.has(topic) || wires.in.length > 0 || isRead;
}
