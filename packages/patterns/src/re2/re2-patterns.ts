import { RE2JS } from 're2js';
import {
  DEFAULT_PATTERN_LIMITS,
  type PatternLimits,
  type CompiledPattern,
  type PatternCompiler,
} from '../pattern-compiler.ts';

/** Regular expressions matched in linear time by a port of RE2. [TD-21] */
export class Re2Patterns implements PatternCompiler {
  readonly #limits: PatternLimits;

  /** @param limits what is not said is as in `DEFAULT_PATTERN_LIMITS` */
  constructor(limits: Partial<PatternLimits> = {}) {
    this.#limits = { ...DEFAULT_PATTERN_LIMITS, ...limits };
  }

  compile(source: string): CompiledPattern {
    const { length, instructions } = this.#limits;
    if (source.length > length) {
      throw new Error(`it has ${source.length} characters, more than ${length}`);
    }
    // Counted repetitions are written out by the compiler, nested ones multiply: a look at the counts
    // spares compiling what would be refused for its size.
    if (sumOfCounts(source) > instructions) throw new Error(this.#tooLarge());
    const unsupported = unsupportedSyntax(source);
    if (unsupported !== undefined) throw new Error(unsupported);
    // Clients write what JavaScript calls a regular expression; where RE2 spells the same thing
    // differently (named groups, escapes), it is translated.
    const pattern = RE2JS.compile(RE2JS.translateRegExp(source));
    if (pattern.programSize() > instructions) throw new Error(this.#tooLarge());
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
    return `the pattern is too large: write it with fewer or smaller counts, at most ${this.#limits.instructions} steps`;
  }
}

/** Explains features of JavaScript that RE2 does not support; the errors of RE2 do not name them. */
function unsupportedSyntax(source: string): string | undefined {
  // Classes hold `(?=` as characters, escapes take the character after them.
  const outside = source.replace(/\\(?![1-9k])[^]|\[(?:\\[^]|[^\]\\])*\]/g, '');
  if (/\(\?<?[=!]/.test(outside)) return 'look-ahead and look-behind are not supported';
  // `\k<name>` would be read as the letter k.
  if (/\\(?:[1-9]|k)/.test(outside)) return 'back-references are not supported';
  return undefined;
}

function sumOfCounts(source: string): number {
  let sum = 0;
  for (const [, least, most] of source.matchAll(/\{(\d{1,9})(?:,(\d{0,9}))?\}/g)) {
    sum += Math.max(Number(least), Number(most || 0));
  }
  return sum;
}
