import type { Session } from '@ubii/proto';
import type { Graph } from '../graph.ts';
import { wiresAt } from '../wires-of.ts';
import type { GraphProblem } from './graph-problem.ts';
import { ownProblems, type Surroundings } from './own-problems.ts';
import { problemsInGraph, type PlacedProblem } from './problems-in-graph.ts';

/** All problems of a graph, by element. */

export interface GraphProblems {
  /** Without duplicates, errors first. */
  readonly all: readonly GraphProblem[];
  readonly ofNode: ReadonlyMap<string, readonly GraphProblem[]>;
  /** By node and port, separated by a space. */
  readonly ofPort: ReadonlyMap<string, readonly GraphProblem[]>;
  readonly ofWire: ReadonlyMap<string, readonly GraphProblem[]>;
}

/**
 * Combines the master's problems of the saved session with those detected in the edited graph.
 * @param session as stored on the master
 */
export function graphProblems(
  graph: Graph,
  session: Pick<Session, 'ioMappings' | 'processingModules' | 'extension'>,
  around: Surroundings,
): GraphProblems {
  const own = ownProblems(graph, around);
  const told = problemsInGraph(graph, session).flatMap(
    (placed) => toldProblem(graph, placed, around, session) ?? [],
  );
  const isTold = ({ code, node, port }: GraphProblem): boolean =>
    told.some(
      (one) => one.node === node && one.code === code && (one.port ?? port) === (port ?? one.port),
    );
  const hasCycle = told.some(({ code }) => code.endsWith('cycle'));
  const more = own
    .filter((one) => !isTold(one))
    .map((one) => (hasCycle && one.code === 'cycle' ? { ...one, isEcho: true } : one));
  const every = [...told, ...more];
  every.sort((a, b) => Number(b.isError) - Number(a.isError));
  return {
    all: every.filter(({ isEcho }) => isEcho !== true),
    ofNode: grouped(every, ({ node }) => (node === undefined ? [] : [node])),
    ofPort: grouped(every, ({ node, port }) => (port === undefined ? [] : [`${node} ${port}`])),
    ofWire: grouped(every, ({ wires }) => wires),
  };
}

/** Returns undefined when the problem is solved by unsaved changes, or its topic only waits for a touch. */
function toldProblem(
  graph: Graph,
  placed: PlacedProblem,
  { remedyOf, isResting }: Surroundings,
  session: Pick<Session, 'ioMappings'>,
): GraphProblem | undefined {
  const { problem, node, port, wires } = placed;
  const { code, isError, message, path } = problem;
  const isAboutWire = path.endsWith('.topic') || path.includes('.topicMux');
  if (isAboutWire && node !== undefined && port !== undefined) {
    if (wiresAt(graph, { node, port }).length === 0) return undefined;
  }
  const topic = code === 'topic_without_record' ? sourceTopic(graph, wires) : undefined;
  if (topic !== undefined && isResting?.(topic) === true) return undefined;
  if (topic !== undefined && !isSavedInput(session, path, topic)) return undefined;
  const advice = topic === undefined ? undefined : remedyOf?.(topic);
  const told = { code, isError, message, node, port, wires };
  if (advice === undefined) return told;
  const remedy = advice.text === undefined ? {} : { remedy: advice };
  return { ...told, message: advice.message, ...remedy };
}

const INPUT_TOPIC = /^ioMappings\[(\d+)\]\.inputMappings\[(\d+)\]\.topic$/;

/** Whether the input of a problem has this topic in the saved session. */
function isSavedInput(
  { ioMappings }: Pick<Session, 'ioMappings'>,
  path: string,
  topic: string,
): boolean {
  const [, mapping, input] = INPUT_TOPIC.exec(path) ?? [];
  const saved = ioMappings[Number(mapping)]?.inputMappings[Number(input)]?.topic;
  return saved === undefined || saved === topic;
}

function sourceTopic(graph: Graph, [id]: readonly string[]): string | undefined {
  const source = graph.nodes.get(graph.wires.get(id ?? '')?.from.node ?? '');
  return source?.kind === 'topic' ? source.topic : undefined;
}

function grouped(
  all: readonly GraphProblem[],
  keysOf: (problem: GraphProblem) => readonly string[],
): ReadonlyMap<string, readonly GraphProblem[]> {
  const groups = new Map<string, GraphProblem[]>();
  for (const problem of all) {
    for (const key of keysOf(problem)) {
      const group = groups.get(key);
      if (group === undefined) groups.set(key, [problem]);
      // Master and editor report the same problem, for the module and for the topic: show it once per element.
      else if (group.every(({ code }) => code !== problem.code)) group.push(problem);
    }
  }
  return groups;
}
