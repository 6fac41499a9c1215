/**
 * Returns a regular expression that finds in a topic below a prefix what the given one finds in the topic itself, with the same
 * capture groups.
 *
 * @param prefix letters, digits, `-` and `/`, which mean themselves in an expression
 */
export function prefixedPattern(source: string, prefix: string): string {
  return alternativesOf(source)
    .map((part) =>
      part.startsWith('^') ? `^${prefix}${part.slice(1)}` : `^${prefix}.*?(?:${part})`,
    )
    .join('|');
}

/** The alternatives of an expression that are in no group. */
function alternativesOf(source: string): string[] {
  const alternatives: string[] = [];
  let start = 0;
  let depth = 0;
  let isInClass = false;
  for (let at = 0; at < source.length; at++) {
    const char = source[at];
    if (char === '\\') at++;
    else if (isInClass) isInClass = char !== ']';
    else if (char === '[') isInClass = true;
    else if (char === '(') depth++;
    else if (char === ')') depth--;
    else if (char === '|' && depth === 0) {
      alternatives.push(source.slice(start, at));
      start = at + 1;
    }
  }
  return [...alternatives, source.slice(start)];
}
