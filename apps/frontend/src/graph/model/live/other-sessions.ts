import { sharedWords, type SessionRef } from '../../../sessions/words/shared-topics.ts';
import type { Graph } from '../graph.ts';
import { topicNodeId } from '../make-node.ts';
import type { GraphProblem } from './graph-problem.ts';

/** Other running sessions that write a topic, by topic. */
export type OtherWriters = ReadonlyMap<string, readonly SessionRef[]>;

/** Problems of topics that modules of this graph and other sessions write, at the topic or its wires. */
export function* writtenElsewhere(graph: Graph, writers: OtherWriters): Iterable<GraphProblem> {
  if (writers.size === 0) return;
  const wires = new Map<string, string[]>();
  for (const { id, from, to, via } of graph.wires.values()) {
    const source = graph.nodes.get(from.node);
    const target = graph.nodes.get(to.node);
    if (source?.kind === 'module' && source.standing !== 'active') continue;
    const topic = via ?? (target?.kind === 'topic' ? target.topic : undefined);
    if (topic !== undefined && writers.has(topic))
      wires.set(topic, [...(wires.get(topic) ?? []), id]);
  }
  for (const [topic, ids] of wires) {
    const others = writers.get(topic) ?? [];
    const node = topicNodeId(topic);
    const [wire] = ids.map((id) => graph.wires.get(id));
    const isDrawn = graph.nodes.has(node);
    yield {
      code: 'topic_written_elsewhere',
      isError: false,
      message: sharedWords({ topic, others }),
      node: isDrawn ? node : wire?.from.node,
      port: isDrawn ? undefined : wire?.from.port,
      wires: ids,
      others,
    };
  }
}
