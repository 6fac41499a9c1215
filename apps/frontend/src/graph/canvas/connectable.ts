import { portName } from '../model/commands/command-label.ts';
import { endOf } from '../model/fit/wire-end.ts';
import { fittingPorts } from '../model/fit/fitting.ts';
import type { KnownTopic } from '../model/fit/node-offer.ts';
import { closeness, isInUse } from '../model/fit/rank-offers.ts';
import type { Graph, Point, PortRef } from '../model/graph.ts';
import { portFormat, portOf } from '../model/port-format.ts';
import { wiresAt, wiresOf } from '../model/wires-of.ts';
import type { Addable } from './addable.ts';

/** Existing socket that a wire fits. */
export type Connectable = Addable & {
  /** The wire would lead back to where it comes from. */
  readonly isLoop: boolean;
};

/**
 * Returns the existing sockets that a wire from this one fits: first those that replace no other wire, then by fit,
 * then by distance; at the end those that make a loop. Topics in use are not offered as targets. [SE-70]
 * @param typed words that names must contain
 * @param published topics that have a publisher
 * @param placeOf position of a socket on the canvas
 */
export function connectables(
  graph: Graph,
  from: PortRef,
  typed: string,
  published: readonly KnownTopic[],
  placeOf: (ref: PortRef) => Point | undefined,
): Connectable[] {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const start = placeOf(from);
  const far = (ref: PortRef): number => {
    const place = placeOf(ref);
    return start && place ? Math.hypot(place.x - start.x, place.y - start.y) : Infinity;
  };
  const isJoined = (ref: PortRef): boolean =>
    wiresAt(graph, ref).some(({ from: a, to: b }) =>
      [a, b].some(({ node, port }) => node === from.node && port === from.port),
    );
  const isPublished = new Set(published.map(({ topic }) => topic));
  const isOutput = portOf(graph, from)?.direction === 'out';
  const mixes = ({ node }: PortRef): boolean => {
    const other = graph.nodes.get(node);
    return (
      isOutput && other?.kind === 'topic' && isInUse(graph, from.node, other.topic, isPublished)
    );
  };
  return (
    fittingPorts(graph, from)
      .filter((port) => !isJoined(port) && !mixes(port))
      // A module is rarely wired to itself: offered only when searched by name.
      .filter(({ node }) => node !== from.node || words.length > 0)
      .map((port) => ({
        port,
        isTaken: isTaken(graph, port),
        isLoop: isOutput ? leadsTo(graph, port, from) : leadsTo(graph, from, port),
        close: closenessOf(graph, from, port),
        far: far(port),
      }))
      .sort(
        (a, b) =>
          Number(a.isLoop) - Number(b.isLoop) ||
          Number(a.isTaken) - Number(b.isTaken) ||
          a.close - b.close ||
          a.far - b.far,
      )
      .map(({ port, isLoop, isTaken: taken }) => {
        const format = portFormat(graph, port) ?? portOf(graph, port)?.formatText ?? '';
        const hint = [format, taken ? 'replaces a wire' : '', isLoop ? 'makes a loop' : '']
          .filter(Boolean)
          .join(', ');
        return {
          key: `socket ${port.node} ${port.port}`,
          text: portName(graph, port),
          hint,
          port,
          isLoop,
        };
      })
      .filter(({ text, hint }) =>
        words.every((word) => `${text} ${hint}`.toLowerCase().includes(word)),
      )
  );
}

function closenessOf(graph: Graph, from: PortRef, to: PortRef): number {
  const [own, other] = [endOf(graph, from), endOf(graph, to)];
  return own === undefined || other === undefined ? 0 : closeness(own, other);
}

/** True when values go from the one node to the other, through whatever is between them. */
function leadsTo(graph: Graph, { node: start }: PortRef, { node: end }: PortRef): boolean {
  const seen = new Set<string>();
  const next = [start];
  for (let node = next.pop(); node !== undefined; node = next.pop()) {
    if (node === end) return true;
    if (seen.has(node)) continue;
    seen.add(node);
    next.push(...wiresOf(graph, node).out.map(({ to }) => to.node));
  }
  return false;
}

/** Returns the socket at the other end of the wire that a new one would replace: an input of a module takes one. */
export function replacedAt(graph: Graph, ref: PortRef): PortRef | undefined {
  return isTaken(graph, ref) ? wiresAt(graph, ref)[0]?.from : undefined;
}

/** An input of a module takes one wire; a new wire replaces the old one. */
function isTaken(graph: Graph, ref: PortRef): boolean {
  const isInput = portOf(graph, ref)?.direction === 'in';
  const isModule = graph.nodes.get(ref.node)?.kind === 'module';
  return isInput && isModule && wiresAt(graph, ref).length > 0;
}
