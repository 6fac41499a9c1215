import { compileGlob } from './glob.ts';
import type { CompiledPattern, PatternCompiler } from './pattern-compiler.ts';
import { remembered, type MatchBudget, type RememberOptions } from './remembered.ts';

/** Dependencies of metered patterns. */
export interface MeterOptions {
  /** Of all patterns together. */
  readonly budget: MatchBudget;
  readonly monotonicMs: () => number;
  /** Texts whose answer each pattern remembers, the newest ones. @default 8192 */
  readonly maxTexts?: number;
}

/** Patterns that are remembered, the newest ones: those of a large session. */
const MAX_SOURCES = 64;

/**
 * Patterns that remember their answers, so that a topic is matched once and not with every record, and
 * that stop when finding answers takes longer than their budget allows: what they give throws a
 * `MatchBudgetError` then.
 */
export class MeteredPatterns implements PatternCompiler {
  readonly #options: MeterOptions;
  readonly #compile: (source: string) => CompiledPattern;
  readonly #compileGlob: (glob: string) => (topic: string) => boolean;

  constructor(compiler: PatternCompiler, options: MeterOptions) {
    this.#options = options;
    this.#compile = remembered(
      (source) => {
        const compiled = compiler.compile(source);
        const meter = this.#optionsFor(source);
        return {
          test: remembered((text) => compiled.test(text), meter),
          match: remembered((text) => compiled.match(text), meter),
        };
      },
      { maxTexts: MAX_SOURCES },
    );
    this.#compileGlob = remembered(
      (glob) => remembered(compileGlob(glob), this.#optionsFor(glob)),
      { maxTexts: MAX_SOURCES },
    );
  }

  /** The same pattern, with what it remembers, for the same source. */
  compile(source: string): CompiledPattern {
    return this.#compile(source);
  }

  /** The same for a glob. */
  compileGlob(glob: string): (topic: string) => boolean {
    return this.#compileGlob(glob);
  }

  #optionsFor(source: string): RememberOptions {
    const { budget, monotonicMs, maxTexts } = this.#options;
    const meter = { budget, monotonicMs, source };
    return maxTexts === undefined ? { meter } : { meter, maxTexts };
  }
}
