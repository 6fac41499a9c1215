const rules = new Intl.PluralRules('en');

/**
 * Returns the form of a word, or of a part of a sentence, for a number of things.
 *
 * @param one form for 1
 * @param other form for 0, 2 and more, and fractions; by default `one` with an s
 */
export function plural(number: number, one: string, other = `${one}s`): string {
  return rules.select(number) === 'one' ? one : other;
}

/** Returns a number with its noun: `1 session`, `3 sessions`. Parameters as those of `plural`. */
export function counted(number: number, one: string, other?: string): string {
  return `${number} ${plural(number, one, other)}`;
}
