import { globToRegExpSource, isExtensionTopic } from '@ubii/proto';
import { profileToMessage } from './component-profile.ts';
import type { ComponentProfile } from './component-profile.ts';

/**
 * What a subscription selects: one topic · a glob, where `*` stands for any characters within one
 * segment, `**` for any characters and `?` for one · an unanchored regular expression, as source or
 * as a RegExp without flags, of what JavaScript and RE2 both know · the topics of all components
 * that match a profile, of devices that come later as well.
 */
export type TopicPattern =
  | { readonly topic: string }
  | { readonly glob: string }
  | { readonly regex: string | RegExp }
  | { readonly component: ComponentProfile };

/** A pattern in the form the master is asked for. Two of the same `key` are one subscription there. */
export type ServerPattern =
  | { readonly kind: 'topic'; readonly key: string; readonly topic: string }
  | {
      readonly kind: 'regex';
      readonly key: string;
      readonly source: string;
      readonly matches: (topic: string) => boolean;
    }
  | { readonly kind: 'component'; readonly key: string; readonly profile: ComponentProfile };

/**
 * Checks a pattern and brings it into the form the master is asked for.
 * @throws {TypeError} if it is empty, or not a regular expression
 */
export function toServerPattern(pattern: TopicPattern): ServerPattern {
  if ('topic' in pattern) {
    const topic = nonEmpty('topic', pattern.topic);
    return { kind: 'topic', key: `topic ${topic}`, topic };
  }
  if ('glob' in pattern) return regexPattern(globToRegExpSource(nonEmpty('glob', pattern.glob)));
  if ('regex' in pattern) return regexPattern(sourceOf(pattern.regex));
  const { component: profile } = pattern;
  return {
    kind: 'component',
    key: `component ${JSON.stringify(profileToMessage(profile))}`,
    profile,
  };
}

function regexPattern(source: string): ServerPattern {
  const expression = compile(source);
  // [TD-26] a pattern that does not say so does not mean the topics of the master's own.
  const meansExtensionTopics = /^\^?\/ubii\//.test(source);
  return {
    kind: 'regex',
    key: `regex ${source}`,
    source,
    matches: (topic) =>
      (meansExtensionTopics || !isExtensionTopic(topic)) && expression.test(topic),
  };
}

function sourceOf(regex: string | RegExp): string {
  if (typeof regex === 'string') return nonEmpty('regular expression', regex);
  if (regex.flags === '') {
    // A RegExp literal has to write "/" as "\/", which RE2 reads as well; TD-26 looks at the text.
    return regex.source.replaceAll('\\/', '/');
  }
  throw new TypeError(
    `Expected a regular expression without flags, because the master knows none, received "${String(regex)}"`,
  );
}

function compile(source: string): RegExp {
  try {
    return new RegExp(source);
  } catch (cause) {
    throw new TypeError(`Expected a regular expression, received "${source}"`, { cause });
  }
}

function nonEmpty(what: string, text: string): string {
  if (typeof text === 'string' && text !== '') return text;
  throw new TypeError(`Expected a ${what} to subscribe to, received ${JSON.stringify(text)}`);
}
