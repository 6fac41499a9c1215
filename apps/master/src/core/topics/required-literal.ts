/** Text that every match of a pattern contains; at the start of the topic when `isPrefix`. */
export interface RequiredLiteral {
  readonly text: string;
  readonly isPrefix: boolean;
}

const METACHARACTERS = new Set('\\^$.|?*+()[]{}');
/** Letters that, after a backslash, stand for one character or for a place between two. */
const SKIPPED_ESCAPES = new Set('dDwWsSbBAztnrfv');

/**
 * Finds text that a topic must contain for a regular expression to match, so that most patterns are
 * ruled out by one comparison of strings when a new topic appears. Reads only what is plain in the
 * pattern (no alternation, no flags, what stands outside of groups) and gives up on anything else.
 * @param source A valid RE2 pattern.
 */
export function requiredLiteral(source: string): RequiredLiteral | undefined {
  const runs: { text: string; isPrefix: boolean }[] = [];
  let isPrefix = source.startsWith('^');
  let run = '';
  const endRun = (): void => {
    if (run !== '') runs.push({ text: run, isPrefix });
    run = '';
    isPrefix = false;
  };
  let i = isPrefix ? 1 : 0;
  while (i < source.length) {
    let literal: string | undefined;
    const char = source[i]!;
    // An alternative, or a quantifier of a quantifier or of the anchor.
    if (char === '|' || char === '*' || char === '?' || char === '+') return undefined;
    if (char === '(') {
      const end = endOfGroup(source, i);
      if (end === undefined) return undefined;
      i = end;
    } else if (char === '[') {
      const end = endOfClass(source, i);
      if (end === undefined) return undefined;
      i = end;
    } else if (char === '\\') {
      const escaped = source[i + 1];
      if (escaped === undefined || isLetterOrDigit(escaped)) {
        // Classes and assertions are skipped; quotations, properties, code points are not worth it.
        if (!SKIPPED_ESCAPES.has(escaped ?? '')) return undefined;
      } else literal = escaped;
      i += 2;
    } else if (METACHARACTERS.has(char)) {
      i += 1;
    } else {
      // A character outside the basic plane is one character to RE2 and two units here.
      literal = String.fromCodePoint(source.codePointAt(i)!);
      i += literal.length;
    }
    const quantifier = source[i];
    const isOptional = quantifier === '*' || quantifier === '?' || quantifier === '{';
    if (literal === undefined || isOptional) endRun();
    else {
      run += literal;
      if (quantifier === '+') endRun();
    }
    if (isOptional || quantifier === '+') {
      i = endOfQuantifier(source, i);
    }
  }
  endRun();
  const prefix = runs.find((candidate) => candidate.isPrefix);
  const longest = runs.reduce<RequiredLiteral | undefined>(
    (best, candidate) =>
      best === undefined || candidate.text.length > best.text.length ? candidate : best,
    undefined,
  );
  // A prefix is the cheaper and usually the sharper test, unless it is next to nothing.
  return prefix !== undefined && prefix.text.length >= 4 ? prefix : longest;
}

/** Index after the group that begins at `start`; undefined when its flags may change what follows. */
function endOfGroup(source: string, start: number): number | undefined {
  if (source[start + 1] === '?' && source[start + 2] !== ':') return undefined;
  let i = start + 1;
  while (i < source.length && source[i] !== ')') {
    if (source[i] === '\\') {
      if (source[i + 1] === 'Q') return undefined;
      i += 2;
    } else if (source[i] === '(' || source[i] === '[') {
      const end = source[i] === '(' ? endOfGroup(source, i) : endOfClass(source, i);
      if (end === undefined) return undefined;
      i = end;
    } else i += 1;
  }
  return i < source.length ? i + 1 : undefined;
}

/** Index after the character class that begins at `start`. */
function endOfClass(source: string, start: number): number | undefined {
  let i = start + 1;
  if (source[i] === '^') i += 1;
  // A bracket that comes first stands for itself.
  if (source[i] === ']') i += 1;
  while (i < source.length && source[i] !== ']') {
    if (source[i] === '\\') i += 2;
    else if (source[i] === '[' && source[i + 1] === ':') {
      const end = source.indexOf(':]', i + 2);
      i = end === -1 ? i + 1 : end + 2;
    } else i += 1;
  }
  return i < source.length ? i + 1 : undefined;
}

/** Index after the quantifier at `start`, its lazy mark included. */
function endOfQuantifier(source: string, start: number): number {
  let i = start + 1;
  if (source[start] === '{') {
    const end = source.indexOf('}', start);
    i = end === -1 ? start + 1 : end + 1;
  }
  return source[i] === '?' ? i + 1 : i;
}

function isLetterOrDigit(char: string): boolean {
  return /[A-Za-z0-9]/.test(char);
}
