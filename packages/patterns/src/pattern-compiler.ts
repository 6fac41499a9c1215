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
