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
