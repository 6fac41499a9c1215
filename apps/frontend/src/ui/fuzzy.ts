/** True when a word begins there, also within an identifier. */
export const isWordStart = (text: string, index: number): boolean => {
  if (index === 0) return true;
  const before = text.charAt(index - 1);
  if (/[\s/_\-.·]/.test(before)) return true;
  return /[a-z]/.test(before) && /[A-Z]/.test(text.charAt(index));
};

/** Score for the letters of a word in order; `undefined` when one is missing. */
function scoreWord(word: string, text: string, lower: string): number | undefined {
  const whole = lower.indexOf(word);
  if (whole >= 0) {
    return 100 + word.length * 4 + (isWordStart(text, whole) ? 40 : 0) - Math.min(whole, 30);
  }
  let score = 0;
  let from = 0;
  let previous = -2;
  for (const letter of word) {
    const index = lower.indexOf(letter, from);
    if (index < 0) return undefined;
    if (isWordStart(text, index)) score += 8;
    else if (index === previous + 1) score += 4;
    else score -= 2;
    previous = index;
    from = index + 1;
  }
  // Ignore matches with letters scattered over a long text.
  return score > 0 ? score : undefined;
}

/**
 * Score of a text for a query: every word must occur, as a substring or letter by letter in order. Higher is better;
 * `undefined`: no match; 0 for an empty query.
 */
export function fuzzyScore(query: string, text: string): number | undefined {
  const lower = text.toLowerCase();
  let total = 0;
  for (const word of query.toLowerCase().split(/\s+/).filter(Boolean)) {
    const score = scoreWord(word, text, lower);
    if (score === undefined) return undefined;
    total += score;
  }
  return total === 0 ? 0 : total - Math.min(text.length, 60) / 10;
}
