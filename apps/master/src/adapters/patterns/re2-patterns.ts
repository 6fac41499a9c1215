import { RE2JS } from 're2js';

import type { CompiledPattern, PatternCompiler } from '../../core/ports/index.ts';

/** Regular expressions matched in linear time by a port of RE2. [TD-21] */
export class Re2Patterns implements PatternCompiler {
  readonly #maxInstructions: number;

  /** @param maxInstructions size of a compiled program: what one character of a topic may cost */
  constructor(maxInstructions: number) {
    this.#maxInstructions = maxInstructions;
  }

  compile(source: string): CompiledPattern {
    // Counted repetitions are written out by the compiler, nested ones multiply: a look at the counts
    // spares compiling what would be refused for its size.
    if (sumOfCounts(source) > this.#maxInstructions) throw new Error(this.#tooLarge());
    // Clients write what JavaScript calls a regular expression; where RE2 spells the same thing
    // differently (named groups, escapes), it is translated.
    const pattern = RE2JS.compile(RE2JS.translateRegExp(source));
    if (pattern.programSize() > this.#maxInstructions) throw new Error(this.#tooLarge());
    return {
      test: (text) => pattern.test(text),
      match(text) {
        const matcher = pattern.matcher(text);
        if (!matcher.find()) return undefined;
        return Array.from(
          { length: matcher.groupCount() + 1 },
          (_, group) => matcher.group(group) ?? undefined,
        );
      },
    };
  }

  #tooLarge(): string {
    return `the pattern is too large: write it with fewer or smaller counts, at most ${this.#maxInstructions} steps`;
  }
}

function sumOfCounts(source: string): number {
  let sum = 0;
  for (const [, least, most] of source.matchAll(/\{(\d{1,9})(?:,(\d{0,9}))?\}/g)) {
    sum += Math.max(Number(least), Number(most || 0));
  }
  return sum;
}
