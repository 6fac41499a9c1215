import { compileGlob, isGlob } from './glob.ts';

/** A parsed search. All terms must match. */
export interface TopicFilter {
  /** True when every topic passes. */
  readonly isEmpty: boolean;
  /**
   * @param topic the topic
   * @param names names and ids of its clients: the one whose id it starts with, and the publisher
   */
  accepts(topic: string, names: readonly string[]): boolean;
}

type Term = (topic: string, lowerTopic: string, lowerNames: readonly string[]) => boolean;

export const EMPTY_FILTER: TopicFilter = { isEmpty: true, accepts: () => true };

/**
 * Parses the search field. Words match text anywhere in the topic or its client's name, case-insensitively; words with
 * `*` or `?` are globs over levels; `client:name` matches clients only. Words are separated by spaces; quotes keep them
 * together.
 */
export function parseTopicFilter(search: string): TopicFilter {
  const words = search.match(/(?:[^\s"]|"[^"]*"?)+/g) ?? [];
  const terms = words.flatMap((word) => toTerm(word) ?? []);
  if (terms.length === 0) return EMPTY_FILTER;
  return {
    isEmpty: false,
    accepts(topic, names) {
      const lowerTopic = topic.toLowerCase();
      const lowerNames = names.map((name) => name.toLowerCase());
      return terms.every((term) => term(topic, lowerTopic, lowerNames));
    },
  };
}

function toTerm(word: string): Term | undefined {
  const client = /^client:(.*)$/is.exec(word)?.[1];
  const text = (client ?? word).replaceAll('"', '').toLowerCase();
  if (text === '') return undefined;
  if (client !== undefined)
    return (_topic, _lower, names) => names.some((name) => name.includes(text));
  if (isGlob(text)) {
    const selects = compileGlob(text);
    return (_topic, lowerTopic) => selects(lowerTopic);
  }
  return (_topic, lowerTopic, names) =>
    lowerTopic.includes(text) || names.some((name) => name.includes(text));
}
