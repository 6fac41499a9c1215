import type { Graph, PortRef } from '../graph.ts';
import { ioName } from '../ports.ts';

/** Every topic of a graph, with a node or without. */
export function topicsOf(graph: Graph): Set<string> {
  const topics = new Set<string>();
  for (const node of graph.nodes.values()) if (node.kind === 'topic') topics.add(node.topic);
  for (const { via } of graph.wires.values()) if (via !== undefined) topics.add(via);
  return topics;
}

/** A topic for what comes out of a module, which the graph does not have yet. */
export function freeTopic(graph: Graph, { node, port }: PortRef): string {
  const source = graph.nodes.get(node);
  const name = source?.kind === 'module' ? source.module.name : '';
  const parts = [graph.details.name || 'session', name || 'module', ioName(port)];
  return unusedTopic(topicsOf(graph), `/${parts.map(topicPart).join('/')}`);
}

/**
 * A short topic for what comes out of a module, for those who are shown it and may choose another.
 * Modules that are wired to each other get longer ones: two people may do that at the same time.
 */
export function proposedTopic(graph: Graph, ref: PortRef): string {
  const short = `/${topicPart(graph.details.name || 'session')}/${topicPart(ioName(ref.port))}`;
  return topicsOf(graph).has(short) ? freeTopic(graph, ref) : short;
}

/** The topic itself, or with the first number that makes it new. */
export function unusedTopic(taken: ReadonlySet<string>, wished: string): string {
  let topic = wished;
  for (let number = 2; taken.has(topic); number += 1) topic = `${wished}-${number}`;
  return topic;
}

/** Text as one part of a topic, between slashes and without signs that patterns know. */
export function topicPart(text: string): string {
  const part = text
    .normalize('NFC')
    .replaceAll(/[^\p{L}\p{N}_-]+/gu, '-')
    .replaceAll(/^-+|-+$/g, '')
    .slice(0, 60);
  return part === '' ? 'x' : part;
}
