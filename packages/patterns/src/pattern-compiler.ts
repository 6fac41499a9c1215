/** Cost limits of a regular expression. */
export interface PatternLimits {
  /** UTF-16 code units of a source. */
  readonly length: number;
  /** Instructions of a compiled program: what one character of a text may cost at worst. */
  readonly instructions: number;
}

/** The limits of nodes and pages, and of a master that was not told otherwise. */
export const DEFAULT_PATTERN_LIMITS: PatternLimits = {
  // Compiling grows with it.
  length: 1024,
  // A UUID takes some 60.
  instructions: 1024,
};

/** A compiled regular expression. */
export interface CompiledPattern {
  /** Whether the pattern matches anywhere in `text` (unanchored). Time is linear in `text.length`. */
  test(text: string): boolean;
  /**
   * The first match anywhere in `text`: the whole of it, then its capture groups by their numbers, named
   * ones too; a group that took no part is undefined. Undefined when there is no match.
   */
  match(text: string): readonly (string | undefined)[] | undefined;
}

/** Compiles regular expressions whose matching time is linear in the text, whatever the pattern. */
export interface PatternCompiler {
  /**
   * @param source A regular expression with RE2 syntax, case-sensitive.
   * @throws Error when the source is not RE2 (back-references, look-around, ...) or too large; the
   *   message says why in a few words, fit to be shown to the person who wrote the pattern.
   */
  compile(source: string): CompiledPattern;
}
