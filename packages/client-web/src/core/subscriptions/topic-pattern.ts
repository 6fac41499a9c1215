import { compileGlob, remembered, type PatternCompiler, type PatternSource } from '@ubii/patterns';
import { globToRegExpSource, isExtensionTopic } from '@ubii/proto';
import { profileToMessage } from './component-profile.ts';
import type { ComponentProfile } from './component-profile.ts';

/** Topics whose answers a pattern remembers: as many as those whose receivers are. */
export const MAX_REMEMBERED_TOPICS = 10_000;

/**
 * Selector of a subscription: one topic · a glob, where `*` stands for any characters within one
 * segment, `**` for any characters and `?` for one · an unanchored regular expression, as source or
 * as a RegExp without flags, with the syntax and meaning of RE2 · the topics of all components that
 * match a profile, of devices that come later as well.
 */
export type TopicPattern =
  | { readonly topic: string }
  | { readonly glob: string }
  | { readonly regex: string | RegExp }
  | { readonly component: ComponentProfile };

/** Tells whether a topic is selected. */
export type TopicMatch = (topic: string) => boolean;

/** At hand, or there once the code that matches was loaded; rejects with why it is not to be had. */
export type Matcher =
  | { readonly match: TopicMatch }
  | { readonly match: undefined; readonly load: () => Promise<TopicMatch> };

/** A pattern in the form the master is asked for. Two of the same `key` are one subscription there. */
export type ServerPattern =
  | { readonly kind: 'topic'; readonly key: string; readonly topic: string }
  | {
      readonly kind: 'regex';
      readonly key: string;
      readonly source: string;
      /** Finds the answer for a topic once. */
      readonly matcher: Matcher;
    }
  | { readonly kind: 'component'; readonly key: string; readonly profile: ComponentProfile };

/**
 * Checks a pattern and brings it into the form the master is asked for.
 * @param patterns matches regular expressions; while it has no compiler, they are not checked
 * @throws {TypeError} if it is empty, or not a regular expression
 */
export function toServerPattern(pattern: TopicPattern, patterns: PatternSource): ServerPattern {
  if ('topic' in pattern) {
    const topic = nonEmpty('topic', pattern.topic);
    return { kind: 'topic', key: `topic ${topic}`, topic };
  }
  if ('glob' in pattern) {
    const glob = nonEmpty('glob', pattern.glob);
    const source = globToRegExpSource(glob);
    return regexPattern(source, { match: matchOf(source, compileGlob(glob)) });
  }
  if ('regex' in pattern) {
    const source = sourceOf(pattern.regex);
    return regexPattern(source, matcherOf(source, patterns));
  }
  const { component: profile } = pattern;
  return {
    kind: 'component',
    key: `component ${JSON.stringify(profileToMessage(profile))}`,
    profile,
  };
}

function regexPattern(source: string, matcher: Matcher): ServerPattern {
  return { kind: 'regex', key: `regex ${source}`, source, matcher };
}

function matcherOf(source: string, patterns: PatternSource): Matcher {
  const compileWith = (compiler: PatternCompiler): TopicMatch => {
    try {
      return matchOf(source, compiler.compile(source).test);
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      throw new TypeError(`Expected a regular expression, received "${source}": ${reason}`, {
        cause,
      });
    }
  };
  const { compiler } = patterns;
  if (compiler !== undefined) return { match: compileWith(compiler) };
  return { match: undefined, load: async () => compileWith(await patterns.load()) };
}

function matchOf(source: string, test: TopicMatch): TopicMatch {
  // [TD-26] a pattern that does not say so does not mean the topics of the master's own.
  const meansExtensionTopics = /^\^?\/ubii\//.test(source);
  return remembered((topic) => (meansExtensionTopics || !isExtensionTopic(topic)) && test(topic), {
    maxTexts: MAX_REMEMBERED_TOPICS,
  });
}

function sourceOf(regex: string | RegExp): string {
  if (typeof regex === 'string') return nonEmpty('regular expression', regex);
  if (regex.flags === '') {
    // A RegExp literal has to write "/" as "\/", which RE2 reads as well; TD-26 looks at the text.
    return regex.source.replaceAll('\\/', '/');
  }
  throw new TypeError(
    `Expected a regular expression without flags, because the master supports none, received "${String(regex)}"`,
  );
}

function nonEmpty(what: string, text: string): string {
  if (typeof text === 'string' && text !== '') return text;
  throw new TypeError(`Expected a ${what} to subscribe to, received ${JSON.stringify(text)}`);
}
