/** One level of a topic. */
export interface TopicLevel {
  /** The topic up to and with this level: tells levels of the same name apart. */
  readonly key: string;
  /** The name of this level alone; may be empty, as the protocol allows `//`. */
  readonly label: string;
}

/**
 * The levels of a topic, outermost first: `/a/b` has `/a` and `/a/b`. A topic without a leading slash
 * is a topic of its own, so its levels have keys of their own.
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

/** The outermost level: by convention the id of the client that publishes. */
export function rootLabel(topic: string): string {
  const start = topic.startsWith('/') ? 1 : 0;
  const end = topic.indexOf('/', start);
  return topic.slice(start, end === -1 ? undefined : end);
}
