import type { MatchPattern, PatternPort } from '../ports/pattern-port.ts';

/**
 * The regular expressions of JavaScript. One that is built to be slow holds up the thread it is matched
 * on: for nodes that serve nobody else.
 */
export const REGEXP_PATTERNS: PatternPort = {
  compile(source: string): MatchPattern {
    const pattern = new RegExp(source);
    return { match: (text) => pattern.exec(text) ?? undefined };
  },
};
