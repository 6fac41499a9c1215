type Token = string;

const ANY = '**';
const WITHIN = '*';
const ONE = '?';

/**
 * A glob as people type it into the search, with the wildcards of the protocol (`*` within a level,
 * `**` any text, `?` one character). It selects whole levels: with a leading slash from the first one
 * on, without one from any; what lies below a selected level is selected too.
 *
 * Steps through the text instead of building a regular expression, so that no pattern can take long:
 * at worst the square of the topic's length.
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

/** Greedy, with one point to come back to for each kind of star. */
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
    // No fit: give the last star one character more.
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
