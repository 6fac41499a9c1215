import type { ProcessingModule } from '@ubii/proto';
import type { Adapter } from '../model/fit/adapter.ts';
import { fitOf } from '../model/fit/fit-of.ts';
import type { Graph, PortRef } from '../model/graph.ts';
import { portOf } from '../model/port-format.ts';

/** Result of comparing two ports, in the direction of the data. */
export interface PortFit {
  readonly from: PortRef;
  readonly to: PortRef;
  /** Reason why they do not fit, one sentence; undefined when they fit. */
  readonly reason: string | undefined;
  /** Adapters that would make them fit, best first. */
  readonly offers: readonly Adapter[];
}

/**
 * Returns undefined for the same port, and for ports that do not exist.
 * @param library modules that can be offered as adapters
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
