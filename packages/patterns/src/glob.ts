/** `**`: any text. */
const ANY = -1;
/** `*`: any text within one level. */
const WITHIN = -2;
/** `?`: one character within a level. */
const ONE = -3;

const SLASH = 0x2f;

/**
 * A glob over whole topics: `*` is any text within one level, `**` any text, `?` one character within a
 * level; all else means itself. Selects what `globToRegExpSource` of `@ubii/proto` selects, and needs no
 * engine: pages match globs without loading one. Time is at most the product of both lengths.
 */
export function compileGlob(glob: string): (topic: string) => boolean {
  const tokens = tokensOf(glob);
  return (topic) => matches(tokens, topic);
}

function tokensOf(glob: string): readonly number[] {
  return Array.from(glob.matchAll(/\*\*|[^]/gu), ([token]) => {
    if (token === '**') return ANY;
    if (token === '*') return WITHIN;
    return token === '?' ? ONE : token.codePointAt(0)!;
  });
}

/** All positions in the glob that the text so far leads to, at once. */
function matches(tokens: readonly number[], text: string): boolean {
  let reached = new Uint8Array(tokens.length + 1);
  let next = new Uint8Array(tokens.length + 1);
  enter(tokens, reached, 0);
  for (const character of text) {
    const code = character.codePointAt(0)!;
    next.fill(0);
    let isAlive = false;
    for (let at = 0; at < tokens.length; at++) {
      if (reached[at] === 0) continue;
      const token = tokens[at]!;
      const isStar = token === ANY || token === WITHIN;
      const takes = token === code || token === ANY || (token < ANY && code !== SLASH);
      if (!takes) continue;
      enter(tokens, next, isStar ? at : at + 1);
      isAlive = true;
    }
    if (!isAlive) return false;
    [reached, next] = [next, reached];
  }
  return reached[tokens.length] === 1;
}

/** Reaches a position, and those behind the stars there, which may stand for nothing. */
function enter(tokens: readonly number[], reached: Uint8Array, position: number): void {
  for (let at = position; reached[at] === 0; at++) {
    reached[at] = 1;
    const token = tokens[at];
    if (token !== ANY && token !== WITHIN) return;
  }
}
