/** Pause after which typing starts a new word, milliseconds. */
const WORD_MS = 700;

/** Finds rows by the beginning of their names. */
export class TypeAhead {
  #word = '';
  #typedMs = -Infinity;

  /**
   * @param names of the rows, in lower case
   * @param index the row with the focus
   * @param nowMs of any clock
   * @returns index of the matching row; `undefined` without a match
   */
  type(key: string, names: readonly string[], index: number, nowMs: number): number | undefined {
    const letter = key.toLowerCase();
    const isNewWord = nowMs - this.#typedMs > WORD_MS;
    this.#typedMs = nowMs;
    // The same letter again moves to the next match.
    const isRepeated = !isNewWord && this.#word === letter;
    this.#word = isNewWord || isRepeated ? letter : this.#word + letter;
    const from = isNewWord || isRepeated ? index + 1 : index;
    for (let i = 0; i < names.length; i++) {
      const at = (from + i) % names.length;
      if (names[at]!.startsWith(this.#word)) return at;
    }
    return undefined;
  }
}

/** Whether a key press is a letter for type-ahead, rather than a shortcut. */
export function isTypeAhead(event: KeyboardEvent): boolean {
  const isShortcut = event.ctrlKey || event.metaKey || event.altKey;
  return !isShortcut && /^[\p{L}\p{N}_]$/u.test(event.key);
}
