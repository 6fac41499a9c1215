type Token = string;

const ANY = '**';
const WITHIN = '*';
const ONE = '?';

/**
 * Compiles a glob of the search field, with the wildcards of the protocol (`*` within a level, `**` any text, `?` one
 * character). It matches whole levels: with a leading slash from the first level, without one from any; levels below a
 * match are included.
 *
 * Does not use regular expressions, so that no pattern takes long: at worst quadratic in the topic's length.
 */
export function compileGlob(glob: string): (topic: string) => boolean {
  const tokens = glob.match(/\*\*+|[^]/g) ?? [];
  const normal = tokens.map((token) => (token.length > 2 ? ANY : token));
  const isAnchored = glob.startsWith('/') || glob.startsWith(ANY);
  return (topic) => {
    if (selects(normal, topic, 0)) return true;
    if (isAnchored) return false;
    for (let slash = topic.indexOf('/'); slash !== -1; slash = topic.indexOf('/', slash + 1)) {
      if (selects(normal, topic, slash + 1)) return true;
    }
    return false;
  };
}

/** True for text with a wildcard in it. */
export function isGlob(text: string): boolean {
  return /[*?]/.test(text);
}

/** Greedy, with one backtracking position for each kind of star. */
function selects(tokens: readonly Token[], text: string, from: number): boolean {
  let at = from;
  let token = 0;
  let within: { readonly token: number; at: number } | undefined;
  let any: { readonly token: number; at: number } | undefined;
  for (;;) {
    const wanted = tokens[token];
    if (wanted === undefined) {
      if (at === text.length || text[at] === '/') return true;
    } else if (wanted === ANY) {
      any = { token: ++token, at };
      within = undefined;
      continue;
    } else if (wanted === WITHIN) {
      within = { token: ++token, at };
      continue;
    } else if (at < text.length && (wanted === ONE ? text[at] !== '/' : wanted === text[at])) {
      at++;
      token++;
      continue;
    }
    // Mismatch: the last star takes one more character.
    if (within !== undefined && within.at < text.length && text[within.at] !== '/') {
      at = ++within.at;
      token = within.token;
    } else if (any !== undefined && any.at < text.length) {
      at = ++any.at;
      token = any.token;
      within = undefined;
    } else {
      return false;
    }
  }
}
