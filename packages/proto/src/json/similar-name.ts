/** Names with more wrong letters are another name, not a misspelt one. */
const MAX_WRONG_LETTERS = 2;

/**
 * Returns the name that a misspelt one most likely means: the one with the fewest wrong, missing or
 * surplus letters, at most two and fewer than half of its own; upper and lower case are the same.
 */
export function similarName(misspelt: string, names: readonly string[]): string | undefined {
  let best: string | undefined;
  let fewest = MAX_WRONG_LETTERS + 1;
  for (const name of names) {
    if (Math.abs(name.length - misspelt.length) >= fewest) continue;
    const wrong = distance(misspelt.toLowerCase(), name.toLowerCase());
    if (wrong >= fewest || wrong * 2 >= name.length) continue;
    best = name;
    fewest = wrong;
  }
  return best;
}

/** Levenshtein distance: the fewest insertions, deletions and replacements that turn `a` into `b`. */
function distance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, index) => index);
  for (let i = 1; i <= a.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= b.length; j += 1) {
      const replaced = row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(replaced, row[j]! + 1, next[j - 1]! + 1));
    }
    row = next;
  }
  return row[b.length]!;
}
