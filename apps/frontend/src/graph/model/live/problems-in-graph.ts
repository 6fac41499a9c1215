import type { Session, SessionProblem } from '@ubii/proto';
import { placeOf } from '../../../sessions/words/problem-place.ts';
import type { Graph } from '../graph.ts';
import { moduleNodeId } from '../make-node.ts';
import { inputPort, outputPort } from '../ports.ts';
import { wiresAt } from '../wires-of.ts';

/** A problem with its element. */
export interface PlacedProblem {
  readonly problem: SessionProblem;
  /** Undefined: concerns the session as a whole, or an element that was removed. */
  readonly node: string | undefined;
  readonly port: string | undefined;
  readonly wires: readonly string[];
}

/**
 * Assigns the master's problems of a session to the elements of its graph.
 * @param session the session that the problems refer to, as stored on the master
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
