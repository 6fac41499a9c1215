import type { PatternCompiler } from '../ports/pattern-compiler.ts';
import { Pattern } from './pattern.ts';
import type { TopicEntry } from './topic-entry.ts';
import type { TopicMatching } from './topic-table.ts';

/** Every regular expression somebody subscribed to, each once. */
export class PatternTable implements TopicMatching {
  readonly #compiler: PatternCompiler;
  readonly #patterns = new Map<string, Pattern>();

  constructor(compiler: PatternCompiler) {
    this.#compiler = compiler;
  }

  get size(): number {
    return this.#patterns.size;
  }

  get(source: string): Pattern | undefined {
    return this.#patterns.get(source);
  }

  /**
   * Adds a pattern that is not there yet, and finds the entries it matches.
   * @throws Error with the reason when it is not RE2 [TD-21].
   */
  create(source: string, entries: Iterable<TopicEntry>): Pattern {
    const pattern = new Pattern(source, this.#compiler.compile(source));
    this.#patterns.set(source, pattern);
    for (const entry of entries) {
      if (pattern.matches(entry)) {
        entry.patterns.push(pattern);
        pattern.entries.add(entry);
      }
    }
    return pattern;
  }

  forgetIfUnused(pattern: Pattern): void {
    if (pattern.subscribers.size > 0) return;
    this.#patterns.delete(pattern.source);
    for (const entry of pattern.entries) {
      entry.patterns = entry.patterns.filter((other) => other !== pattern);
    }
    pattern.entries.clear();
  }

  attach(entry: TopicEntry): void {
    for (const pattern of this.#patterns.values()) {
      if (pattern.matches(entry)) {
        entry.patterns.push(pattern);
        pattern.entries.add(entry);
      }
    }
  }

  detach(entry: TopicEntry): void {
    for (const pattern of entry.patterns) pattern.entries.delete(entry);
  }
}
