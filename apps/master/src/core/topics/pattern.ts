import type { CompiledPattern } from '@ubii/patterns';
import type { Account } from '../shares/account.ts';
import { requiredLiteral, type RequiredLiteral } from './required-literal.ts';
import type { SharedPattern, Subscriber, TopicEntry } from './topic-entry.ts';

/** One regular expression, shared by all who subscribed to it. */
export class Pattern implements SharedPattern {
  readonly source: string;
  readonly required: RequiredLiteral | undefined;
  /** Subscribers with their rates in Hz (0: every record). */
  readonly subscribers = new Map<Subscriber, number>();
  /** The topics that match. */
  readonly entries = new Set<TopicEntry>();
  /** The account that it counts for [AC-80]. */
  payer: Account | undefined = undefined;
  readonly #compiled: CompiledPattern;
  readonly #meansExtensions: boolean;

  constructor(source: string, compiled: CompiledPattern) {
    this.source = source;
    this.#compiled = compiled;
    this.required = requiredLiteral(source);
    this.#meansExtensions = source.startsWith('^/ubii/') || source.startsWith('/ubii/');
  }

  /** Time of tests that is not charged to a client yet, milliseconds. */
  unchargedMs = 0;

  /** A cheap look that rules out most topics. */
  mayMatch(entry: TopicEntry): boolean {
    if (entry.isExtension && !this.#meansExtensions) return false; // [TD-26]
    const required = this.required;
    if (required === undefined) return true;
    return required.isPrefix
      ? entry.topic.startsWith(required.text)
      : entry.topic.includes(required.text);
  }

  /** The full answer, for a topic that `mayMatch`. */
  test(entry: TopicEntry): boolean {
    return this.#compiled.test(entry.topic);
  }
}
