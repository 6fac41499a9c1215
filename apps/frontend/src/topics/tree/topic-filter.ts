import { compileGlob, isGlob } from './glob.ts';

/** What a person searches for. All terms must hold. */
export interface TopicFilter {
  /** True when every topic passes. */
  readonly isEmpty: boolean;
  /**
   * @param topic the topic
   * @param names and ids of the clients it may be called by: whose id it begins with, and who publishes
   */
  accepts(topic: string, names: readonly string[]): boolean;
}

type Term = (topic: string, lowerTopic: string, lowerNames: readonly string[]) => boolean;

export const EMPTY_FILTER: TopicFilter = { isEmpty: true, accepts: () => true };

/**
 * Reads the search field. Words are text anywhere in the topic or in its client's name, in any case;
 * words with `*` or `?` are globs over levels; `client:name` looks at clients only. Words are separated
 * by spaces; quotes keep them together.
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
