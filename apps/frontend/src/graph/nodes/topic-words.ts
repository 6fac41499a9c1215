import { topicLevels } from '../../topics/names/topic-path.ts';

/** Last level of a topic, used as title of its node. */
export function shortTopic(topic: string): string {
  return topicLevels(topic).at(-1)?.label || topic || 'No topic yet';
}

/** A topic without its last level. */
export function topicParent(topic: string): string {
  const levels = topicLevels(topic);
  return levels.length < 2 ? '' : levels[levels.length - 2]!.key;
}
