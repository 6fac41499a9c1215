import type { Graph, PortRef } from '../graph.ts';
import { ioName } from '../ports.ts';

/** All topics of a graph, with and without a node. */
export function topicsOf(graph: Graph): Set<string> {
  const topics = new Set<string>();
  for (const node of graph.nodes.values()) if (node.kind === 'topic') topics.add(node.topic);
  for (const { via } of graph.wires.values()) if (via !== undefined) topics.add(via);
  return topics;
}

const NO_TOPICS: ReadonlySet<string> = new Set();

/** First level of the topics that the editor makes for a session of this name. */
export const sessionPart = (name: string): string => topicPart(name || 'session');

/**
 * Returns an unused topic for an output of a module.
 * @param used topics that others use
 */
export function freeTopic(graph: Graph, { node, port }: PortRef, used = NO_TOPICS): string {
  const source = graph.nodes.get(node);
  const name = source?.kind === 'module' ? source.module.name : '';
  const parts = [name || 'module', ioName(port)].map(topicPart);
  const wished = `/${[sessionPart(graph.details.name), ...parts].join('/')}`;
  return unusedTopic(new Set([...topicsOf(graph), ...used]), wished);
}

/**
 * Returns a short topic for an output of a module, for display: the user may change it. Wires between modules use
 * longer topics, because two users may add them at the same time.
 */
export function proposedTopic(graph: Graph, ref: PortRef, used = NO_TOPICS): string {
  const short = `/${sessionPart(graph.details.name)}/${topicPart(ioName(ref.port))}`;
  const isUsed = used.has(short) || topicsOf(graph).has(short);
  return isUsed ? freeTopic(graph, ref, used) : short;
}

/** Returns the topic, with the first number appended that makes it unused. */
export function unusedTopic(taken: ReadonlySet<string>, wished: string): string {
  let topic = wished;
  for (let number = 2; taken.has(topic); number += 1) topic = `${wished}-${number}`;
  return topic;
}

/** Converts a text to one level of a topic: without slashes and pattern characters. */
export function topicPart(text: string): string {
  const part = text
    .normalize('NFC')
    .replaceAll(/[^\p{L}\p{N}_-]+/gu, '-')
    .replaceAll(/^-+|-+$/g, '')
    .slice(0, 60);
  return part === '' ? 'x' : part;
}
