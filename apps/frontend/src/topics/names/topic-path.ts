/** One level of a topic. */
export interface TopicLevel {
  /** The topic up to and including this level; unique for levels of the same name. */
  readonly key: string;
  /** Name of this level; may be empty, as the protocol allows `//`. */
  readonly label: string;
}

/**
 * Levels of a topic, outermost first: `/a/b` has `/a` and `/a/b`. Topics with and without a leading slash differ, so
 * their levels have different keys.
 */
export function topicLevels(topic: string): TopicLevel[] {
  const levels: TopicLevel[] = [];
  let start = topic.startsWith('/') ? 1 : 0;
  for (;;) {
    const slash = topic.indexOf('/', start);
    const end = slash === -1 ? topic.length : slash;
    levels.push({ key: topic.slice(0, end), label: topic.slice(start, end) });
    if (slash === -1) return levels;
    start = slash + 1;
  }
}

/** The outermost level: by convention the id of the publishing client. */
export function rootLabel(topic: string): string {
  const start = topic.startsWith('/') ? 1 : 0;
  const end = topic.indexOf('/', start);
  return topic.slice(start, end === -1 ? undefined : end);
}
