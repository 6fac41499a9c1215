import { formatLook } from '../../../formats/families.ts';
import type { Graph, Point, PortRef } from '../../model/graph.ts';
import { topicNodeId } from '../../model/make-node.ts';
import { portFormat, portOf } from '../../model/port-format.ts';
import {
  findAddables,
  insertables,
  kindOf,
  moduleOf,
  type Addable,
  type AddableSources,
} from '../addable.ts';
import { connectables } from '../connectable.ts';

/** What the palette was opened for. */
export interface PaletteWish {
  /** Fixed end of a dangling wire. */
  readonly end?: PortRef | undefined;
  /** Wire into which the node goes. */
  readonly wire?: string | undefined;
  /** Position of a socket on the canvas: existing sockets that fit the wire are listed, too. */
  readonly placeOf?: ((ref: PortRef) => Point | undefined) | undefined;
  /** Only what fits the wire. */
  readonly isFiltered: boolean;
  /** Names of modules that the user marked. */
  readonly favourites?: readonly string[];
  /** Names of modules that were used lately. */
  readonly recent: readonly string[];
}

/** Short name of the data format that entries must fit; empty: unknown. */
export function wantedFormat(graph: Graph, { end, wire }: PaletteWish): string {
  const ref = end ?? graph.wires.get(wire ?? '')?.from;
  if (ref === undefined) return '';
  return formatLook(portFormat(graph, ref) ?? portOf(graph, ref)?.formatText ?? '').text;
}

/** Returns what matches the typed words; without the filter, what does not fit the wire is last, with the reason. */
export function paletteEntries(
  graph: Graph,
  sources: AddableSources,
  typed: string,
  wish: PaletteWish,
): Addable[] {
  const { end, wire, isFiltered, favourites, recent } = wish;
  const fitting =
    wire === undefined
      ? withSockets(graph, sources, typed, wish)
      : insertables(graph, sources, typed, wire, { favourites, recent });
  if (isFiltered || (end === undefined && wire === undefined)) return fitting;
  const shown = new Set(fitting.map(nameOf));
  const misfit = `Does not fit ${wantedFormat(graph, wish) || 'the wire'}.`;
  const others = findAddables(graph, sources, typed, { favourites, recent });
  return [
    ...fitting,
    ...others.filter((one) => !shown.has(nameOf(one))).map((one) => ({ ...one, misfit })),
  ];
}

/** The same for a node, whether it is offered for a wire or not. */
function nameOf(one: Addable): string {
  const kind = kindOf(one);
  const isNamed = kind === 'topic' || moduleOf(one) !== undefined || kind === undefined;
  return isNamed ? one.key : kind;
}

function withSockets(
  graph: Graph,
  sources: AddableSources,
  typed: string,
  { end, placeOf, favourites, recent }: PaletteWish,
): Addable[] {
  const added = findAddables(graph, sources, typed, { end, favourites, recent });
  if (end === undefined || placeOf === undefined) return added;
  const inGraph = connectables(graph, end, typed, sources.topics, placeOf);
  const shown = new Set(inGraph.map(({ port }) => port?.node));
  const isShown = ({ offer }: Addable): boolean =>
    offer?.kind === 'topic' && shown.has(topicNodeId(offer.topic));
  return [
    ...inGraph.filter(({ isLoop }) => !isLoop),
    ...added.filter((one) => !isShown(one)),
    ...inGraph.filter(({ isLoop }) => isLoop),
  ];
}
