import type { ProcessingModule } from '@ubii/proto';
import type { Adapter } from '../model/fit/adapter.ts';
import { fitOf } from '../model/fit/fit-of.ts';
import type { Graph, PortRef } from '../model/graph.ts';
import { portOf } from '../model/port-format.ts';

/** Whether two ports go together, in the direction values would flow. */
export interface PortFit {
  readonly from: PortRef;
  readonly to: PortRef;
  /** Why not, one sentence; undefined when they fit. */
  readonly reason: string | undefined;
  /** What would make it fit, best first. */
  readonly offers: readonly Adapter[];
}

/**
 * Undefined when there is nothing to say: the same port, or one that is not there.
 * @param library modules that may be offered to go in between
 */
export function fitBetween(
  graph: Graph,
  a: PortRef,
  b: PortRef,
  library: readonly ProcessingModule[],
): PortFit | undefined {
  const [first, second] = [portOf(graph, a), portOf(graph, b)];
  if (first === undefined || second === undefined || first === second) return undefined;
  const [from, to] = first.direction === 'out' ? [a, b] : [b, a];
  const fit = fitOf(graph, from, to, library);
  if (fit.fits) return { from, to, reason: undefined, offers: [] };
  return { from, to, reason: fit.reason, offers: fit.offers };
}
