import { sharedWords, type SessionRef } from '../../../sessions/words/shared-topics.ts';
import type { Graph } from '../graph.ts';
import { topicNodeId } from '../make-node.ts';
import { isOfClient } from '../fit/offers.ts';
import type { GraphProblem } from './graph-problem.ts';

/** Other running sessions that write a topic, by topic. */
export type OtherWriters = ReadonlyMap<string, readonly SessionRef[]>;

/** Gives this session topics of its own, in place of these. */
export type UseOwnTopics = (topics: readonly string[]) => void;

/**
 * Problems of topics that modules of this graph and other sessions write, at the topic or its wires.
 * @param useOwn undefined: the problems have no remedy here
 */
export function* writtenElsewhere(
  graph: Graph,
  writers: OtherWriters,
  useOwn?: UseOwnTopics,
): Iterable<GraphProblem> {
  if (writers.size === 0) return;
  const wires = sharedWires(graph, writers);
  // A topic of a client leads to its device: the sessions share it on purpose.
  const replaceable = [...wires.keys()].filter((topic) => !isOfClient(topic));
  for (const [topic, ids] of wires) {
    const others = writers.get(topic) ?? [];
    const message = sharedWords({ topic, others });
    const node = topicNodeId(topic);
    const [wire] = ids.map((id) => graph.wires.get(id));
    const isDrawn = graph.nodes.has(node);
    const canReplace = useOwn !== undefined && replaceable.includes(topic);
    const remedy = { message, text: 'Use topics of its own', run: () => useOwn?.(replaceable) };
    yield {
      code: 'topic_written_elsewhere',
      isError: false,
      message,
      node: isDrawn ? node : wire?.from.node,
      port: isDrawn ? undefined : wire?.from.port,
      wires: ids,
      others,
      ...(canReplace && { remedy }),
    };
  }
}

/** Wires of active modules to topics that others write, by topic. */
function sharedWires(graph: Graph, writers: OtherWriters): Map<string, string[]> {
  const wires = new Map<string, string[]>();
  for (const { id, from, to, via } of graph.wires.values()) {
    const source = graph.nodes.get(from.node);
    const target = graph.nodes.get(to.node);
    if (source?.kind === 'module' && source.standing !== 'active') continue;
    const topic = via ?? (target?.kind === 'topic' ? target.topic : undefined);
    if (topic !== undefined && writers.has(topic))
      wires.set(topic, [...(wires.get(topic) ?? []), id]);
  }
  return wires;
}
