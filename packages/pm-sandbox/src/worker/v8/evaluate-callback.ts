/** Before the author's text, in its first line: the callback sees a console of its own. */
const PREFIX = '(console)=>(';

/**
 * Makes a callback out of its source. This file is the one place where text becomes code of the
 * engine around it; only trusted code comes here. [PM-51]
 *
 * @param sourceUrl how its lines are called in stacks
 * @param console what it finds under that name
 * @throws what the engine throws for a text that does not parse
 */
export function evaluateCallback(source: string, sourceUrl: string, console: object): unknown {
  // A line end before the bracket: the source may end in a comment.
  const text = `${PREFIX}${source}\n)\n//# sourceURL=${sourceUrl}`;
  // eslint-disable-next-line no-eval -- trusted modules are text that is to be run; indirect: it sees no variable of ours
  const withConsole = (0, eval)(text) as (console: object) => unknown;
  return withConsole(console);
}

/**
 * The value of a script that is a library for trusted code. [PM-90]
 *
 * @param sourceUrl how its lines are called in stacks
 * @throws what the script throws, and SyntaxError when it does not parse
 */
export function evaluateLibrary(script: string, sourceUrl: string): unknown {
  // eslint-disable-next-line no-eval -- a library of an asset set that was verified; indirect: it sees no variable of ours
  return (0, eval)(`${script}\n//# sourceURL=${sourceUrl}`) as unknown;
}

/** Columns that come before the author's text in line 1. */
export const FIRST_LINE_OFFSET = PREFIX.length;
