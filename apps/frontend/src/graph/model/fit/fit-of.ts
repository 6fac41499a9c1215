import { formatsFit } from '@ubii/pm-sandbox';
import type { ProcessingModule } from '@ubii/proto';
import { portName } from '../commands/command-label.ts';
import type { Graph, GraphNode, NodeKind, PortRef } from '../graph.ts';
import type { Adapter, Fit } from './adapter.ts';
import { formatOffers, listOffers } from './offers.ts';
import { endOf, type WireEnd } from './wire-end.ts';

const FITS: Fit = { fits: true };

/**
 * Whether a wire between two ports is possible, by the rules of the master. [SE-4] [PM-31]
 * @param library modules that can be offered as adapters
 */
export function fitOf(
  graph: Graph,
  fromRef: PortRef,
  toRef: PortRef,
  library: readonly ProcessingModule[] = [],
): Fit {
  const from = endOf(graph, fromRef);
  const to = endOf(graph, toRef);
  if (from === undefined || to === undefined) return misfit('One end of the wire was deleted.');
  return fitEnds(graph, from, to, library);
}

/** The same for ends in either order, which need not be in the graph. */
export function fitEnds(
  graph: Graph,
  from: WireEnd,
  to: WireEnd,
  library: readonly ProcessingModule[] = [],
): Fit {
  if (from.port.direction === to.port.direction) {
    const side = from.port.direction === 'out' ? 'outputs' : 'inputs';
    return misfit(`Both ends are ${side}; a wire goes from an output to an input.`);
  }
  if (from.port.direction === 'in') return fitEnds(graph, to, from, library);
  return (
    kindFault(from, to) ??
    listFault(graph, from, to) ??
    formatFault(graph, from, to, library) ??
    FITS
  );
}

function misfit(reason: string, offers: readonly Adapter[] = []): Fit {
  return { fits: false, reason, offers };
}

/** Pairs of node kinds that a session cannot connect, with the reason. */
const NONSENSE: Readonly<Partial<Record<`${NodeKind} ${NodeKind}`, string>>> = {
  'topic topic': 'Topics get values from modules. Add a module between the two topics.',
  'topic demuxer': 'A demuxer publishes the output of a module. Add a module before it.',
  'muxer topic': 'A muxer collects values for a module. Add a module after it.',
  'muxer demuxer': 'A muxer collects values for a module. Add a module between the two.',
  'constant topic': 'A constant can only be connected to a module. Topics get values from modules.',
  'constant demuxer':
    'A constant can only be connected to a module. Demuxers publish outputs of modules.',
};

function kindFault(from: WireEnd, to: WireEnd): Fit | undefined {
  const reason = NONSENSE[`${from.node.kind} ${to.node.kind}`];
  return reason === undefined ? undefined : misfit(reason);
}

/** Modules declare lists only: a port counts as not a list when another port of the module is one. [SE-4] */
function saysWhatIsAList(node: GraphNode): boolean {
  return node.ports.some(({ isList }) => isList);
}

function listFault(graph: Graph, from: WireEnd, to: WireEnd): Fit | undefined {
  if (!from.port.isDeclared || !to.port.isDeclared) return undefined;
  if (from.port.isList === to.port.isList) {
    // A list uses several topics, a wire between modules only one.
    if (!from.port.isList || from.node.kind !== 'module' || to.node.kind !== 'module') {
      return undefined;
    }
    const reason = `${portName(graph, from.ref)} outputs a list. Connect it to ${portName(graph, to.ref)} through one topic for each element.`;
    return misfit(reason, listOffers(graph, from, to));
  }
  // The end that is declared as a list is one; the other end may just lack the declaration.
  const doubtful = from.node.kind === 'muxer' ? to.node : from.node;
  const goesOverATopic = from.node.kind !== 'muxer' && to.node.kind !== 'demuxer';
  if (!goesOverATopic && !saysWhatIsAList(doubtful)) return undefined;
  const [given, taken] = from.port.isList
    ? ['a list of records', 'single records']
    : ['single records', 'a list'];
  const reason = `${portName(graph, from.ref)} outputs ${given}, but ${portName(graph, to.ref)} expects ${taken}.`;
  return misfit(reason, listOffers(graph, from, to));
}

function formatFault(
  graph: Graph,
  from: WireEnd,
  to: WireEnd,
  library: readonly ProcessingModule[],
): Fit | undefined {
  if (formatsFit(from.format, to.format)) return undefined;
  const { format: given = 'something else' } = from;
  const reason = `${portName(graph, from.ref)} outputs ${given}, but ${portName(graph, to.ref)} expects ${to.format ?? 'another format'}.`;
  return misfit(reason, formatOffers(from, to, library));
}
