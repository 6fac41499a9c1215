import type { Session, SessionProblem } from '@ubii/proto';
import { placeOf } from '../../../sessions/words/problem-place.ts';
import type { Graph } from '../graph.ts';
import { moduleNodeId } from '../make-node.ts';
import { inputPort, outputPort } from '../ports.ts';
import { wiresAt } from '../wires-of.ts';

/** A problem where it is. */
export interface PlacedProblem {
  readonly problem: SessionProblem;
  /** Undefined: about the session as a whole, or about what is not in the graph any more. */
  readonly node: string | undefined;
  readonly port: string | undefined;
  readonly wires: readonly string[];
}

/**
 * Puts what the master says about a session where it belongs in the graph.
 * @param session the one the problems are about, as the master has it
 */
export function problemsInGraph(
  graph: Graph,
  session: Pick<Session, 'ioMappings' | 'processingModules' | 'extension'>,
  problems: readonly SessionProblem[] = session.extension?.problems ?? [],
): PlacedProblem[] {
  return problems.map((problem) => {
    const place = placeOf(session, problem.path);
    const id = moduleNodeId(place?.moduleId ?? problem.moduleId);
    const node = graph.nodes.get(id);
    if (node === undefined) return { problem, node: undefined, port: undefined, wires: [] };
    if (place === undefined) return { problem, node: id, port: undefined, wires: [] };
    const port = (place.side === 'input' ? inputPort : outputPort)(place.name);
    const isThere = node.ports.some((one) => one.id === port);
    const wires = wiresAt(graph, { node: id, port }).map((wire) => wire.id);
    return { problem, node: id, port: isThere ? port : undefined, wires };
  });
}
