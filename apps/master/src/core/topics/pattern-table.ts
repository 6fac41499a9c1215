import type { PatternCompiler } from '@ubii/patterns';
import type { Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import { LiteralIndex } from './literal-index.ts';
import { Pattern } from './pattern.ts';
import type { Subscriber, TopicEntry } from './topic-entry.ts';
import type { TopicMatching } from './topic-table.ts';

/** Tests of a pattern are charged together once they took this long, milliseconds: cheap ones stay cheap. */
const CHARGED_MS = 1;

/**
 * Largest charge for one test, or for one pass over many topics, milliseconds: the time that the worst pattern within
 * the limits takes for a topic. More time means that the computer was busy otherwise, for which no client may lose its
 * patterns.
 */
const LONGEST_MS = 30;

/** Dependencies of a pattern table. */
export interface PatternContext {
  readonly compiler: PatternCompiler;
  readonly clock: Clock;
}

/** All regular expressions with a subscription, each once, and the topics that they match [TD-22]. */
export class PatternTable implements TopicMatching {
  /** Called when matching the patterns of a client took longer than it may [TD-29]. */
  readonly onOverdrawn = new Hook<[subscriber: Subscriber]>();
  readonly #context: PatternContext;
  readonly #patterns = new Map<string, Pattern>();
  /** The same, by what a topic must contain: a new topic is tested with few of them. */
  readonly #byLiteral = new LiteralIndex<Pattern>();

  constructor(context: PatternContext) {
    this.#context = context;
  }

  get size(): number {
    return this.#patterns.size;
  }

  get(source: string): Pattern | undefined {
    return this.#patterns.get(source);
  }

  /**
   * Adds a pattern that is not there yet, and finds the entries it matches.
   * @param payer Who spends its time on it.
   * @returns undefined when that took longer than the payer may spend: then nothing was added.
   * @throws Error with the reason when it is not RE2 [TD-21].
   */
  create(source: string, entries: Iterable<TopicEntry>, payer: Subscriber): Pattern | undefined {
    const { compiler, clock } = this.#context;
    if (!payer.patternBudget.spend(0, clock.monotonicMs())) return undefined;
    const startedMs = clock.monotonicMs();
    const pattern = new Pattern(source, compiler.compile(source));
    let chargedMs = startedMs;
    for (const entry of entries) {
      if (!pattern.mayMatch(entry)) continue;
      if (pattern.test(entry)) pattern.entries.add(entry);
      const nowMs = clock.monotonicMs();
      if (nowMs - chargedMs < CHARGED_MS) continue;
      const spentMs = Math.min(nowMs - chargedMs, LONGEST_MS);
      if (!payer.patternBudget.spend(spentMs, nowMs)) return undefined;
      chargedMs = nowMs;
    }
    for (const entry of pattern.entries) entry.patterns.push(pattern);
    this.#patterns.set(source, pattern);
    this.#byLiteral.add(pattern, pattern.required);
    return pattern;
  }

  forgetIfUnused(pattern: Pattern): void {
    if (pattern.subscribers.size > 0) return;
    this.#patterns.delete(pattern.source);
    this.#byLiteral.delete(pattern, pattern.required);
    for (const entry of pattern.entries) {
      entry.patterns = entry.patterns.filter((other) => other !== pattern);
    }
    pattern.entries.clear();
  }

  attach(entry: TopicEntry): void {
    for (const pattern of this.#byLiteral.candidates(entry.topic)) {
      // A test may end subscriptions, with patterns that were still to be tested.
      if (this.#patterns.get(pattern.source) !== pattern) continue;
      if (pattern.mayMatch(entry) && this.#test(pattern, entry)) {
        entry.patterns.push(pattern);
        pattern.entries.add(entry);
      }
    }
  }

  detach(entry: TopicEntry): void {
    for (const pattern of entry.patterns) pattern.entries.delete(entry);
  }

  /** Tests a pattern at the expense of its subscribers, which may end it. */
  #test(pattern: Pattern, entry: TopicEntry): boolean {
    const { clock } = this.#context;
    const startedMs = clock.monotonicMs();
    const matches = pattern.test(entry);
    const nowMs = clock.monotonicMs();
    pattern.unchargedMs += Math.min(nowMs - startedMs, LONGEST_MS);
    if (pattern.unchargedMs < CHARGED_MS) return matches;
    for (const subscriber of [...pattern.subscribers.keys()]) {
      if (!subscriber.patternBudget.spend(pattern.unchargedMs, nowMs)) {
        this.onOverdrawn.emit(subscriber);
      }
    }
    pattern.unchargedMs = 0;
    return matches && pattern.subscribers.size > 0;
  }
}
