/** A regular expression, ready to be matched. */
export interface MatchPattern {
  /**
   * @returns the first match and its capture groups, as `String.match` without flags does; undefined
   *   when there is none
   */
  match(text: string): readonly (string | undefined)[] | undefined;
}

/** Compiles the regular expressions that sessions contain. The master's never takes exponential time. */
export interface PatternPort {
  /** @throws Error with the reason when the source is no regular expression, or is refused */
  compile(source: string): MatchPattern;
}
