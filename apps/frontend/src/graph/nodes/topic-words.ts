import { topicLevels } from '../../topics/names/topic-path.ts';

/** The last level of a topic: what a node is titled. */
export function shortTopic(topic: string): string {
  return topicLevels(topic).at(-1)?.label || topic || 'No topic yet';
}

/** All before its last level. */
export function topicParent(topic: string): string {
  const levels = topicLevels(topic);
  return levels.length < 2 ? '' : levels[levels.length - 2]!.key;
}
