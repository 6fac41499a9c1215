import type { PatternCompiler } from '@ubii/patterns';
import type { Clock } from '@ubii/timing';
import type { RequiredLiteral } from './required-literal.ts';
import { Hook } from '../hooks/hook.ts';
import { Pattern } from './pattern.ts';
import type { Subscriber, TopicEntry } from './topic-entry.ts';
import type { TopicMatching } from './topic-table.ts';

/** Characters of the pieces by which literals are found inside of texts. Shorter literals are not indexed. */
const PIECE_LENGTH = 3;

/**
 * Finds the items whose literal may be in a text without a look at each item: in time that grows with the length of the
 * text and the number of different lengths of prefixes.
 */
export class LiteralIndex<T> {
  /** Items by their prefix, by its length. */
  readonly #byPrefix = new Map<number, Map<string, Set<T>>>();
  /** Items by one piece of their literal. */
  readonly #byPiece = new Map<string, Set<T>>();
  readonly #withoutLiteral = new Set<T>();

  /** @param literal the same as in `delete` */
  add(item: T, literal: RequiredLiteral | undefined): void {
    if (literal === undefined || literal.text.length < PIECE_LENGTH) this.#withoutLiteral.add(item);
    else if (literal.isPrefix) this.#addPrefix(item, literal.text);
    else addTo(this.#byPiece, this.#rarestPiece(literal.text), item);
  }

  delete(item: T, literal: RequiredLiteral | undefined): void {
    this.#withoutLiteral.delete(item);
    if (literal === undefined) return;
    const { text } = literal;
    const prefixes = this.#byPrefix.get(text.length);
    if (prefixes !== undefined) {
      deleteFrom(prefixes, text, item);
      if (prefixes.size === 0) this.#byPrefix.delete(text.length);
    }
    for (const piece of piecesOf(text)) deleteFrom(this.#byPiece, piece, item);
  }

  /** Items whose literal the text may contain, and those without a literal. Some of them are wrong, none is missing. */
  candidates(text: string): Set<T> {
    const found = new Set(this.#withoutLiteral);
    for (const [length, prefixes] of this.#byPrefix) {
      if (length > text.length) continue;
      for (const item of prefixes.get(text.slice(0, length)) ?? []) found.add(item);
    }
    if (this.#byPiece.size === 0) return found;
    for (const piece of piecesOf(text)) {
      for (const item of this.#byPiece.get(piece) ?? []) found.add(item);
    }
    return found;
  }

  #addPrefix(item: T, text: string): void {
    let prefixes = this.#byPrefix.get(text.length);
    if (prefixes === undefined) this.#byPrefix.set(text.length, (prefixes = new Map()));
    addTo(prefixes, text, item);
  }

  /** Literals have pieces in common: those of devices all contain `/devices/`. */
  #rarestPiece(text: string): string {
    const countOf = (piece: string): number => this.#byPiece.get(piece)?.size ?? 0;
    return piecesOf(text).reduce((best, piece) => (countOf(piece) < countOf(best) ? piece : best));
  }
}

function piecesOf(text: string): string[] {
  const count = Math.max(0, text.length - PIECE_LENGTH + 1);
  return Array.from({ length: count }, (_, i) => text.slice(i, i + PIECE_LENGTH));
}

function addTo<T>(sets: Map<string, Set<T>>, key: string, item: T): void {
  const set = sets.get(key);
  if (set === undefined) sets.set(key, new Set([item]));
  else set.add(item);
}

function deleteFrom<T>(sets: Map<string, Set<T>>, key: string, item: T): void {
  const set = sets.get(key);
  set?.delete(item);
  if (set?.size === 0) sets.delete(key);
}

/** Tests of a pattern are charged together once they took this long, milliseconds: cheap ones stay cheap. */
const CHARGED_MS = 1;

/**
 * Largest charge for one test, or for one pass over many topics, milliseconds: the time that the worst pattern within
 * the limits takes for a topic. More time means that the computer was busy otherwise, for which no client may lose its
 * patterns.
 */
const MAX_MS = 30;

/** Dependencies of a pattern table. */
interface PatternContext {
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
      const spentMs = Math.min(nowMs - chargedMs, MAX_MS);
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
    pattern.unchargedMs += Math.min(nowMs - startedMs, MAX_MS);
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
