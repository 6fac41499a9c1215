/** Longer texts are kept as they come, characters. */
const MAX_TEXT_CHARACTERS = 256;
/** Texts that are remembered, and the same number of lists; together at most some 2 MiB. */
const MAX_TEXTS = 4_096;

/**
 * Keeps equal texts once: devices of one kind have the same formats, tags and descriptions, and stay for as long as
 * their client may return. [CL-14]
 */
export class SharedTexts {
  readonly #texts = new Map<string, string>();
  readonly #lists = new Map<string, readonly string[]>();

  /** Returns an equal text, the same one each time. */
  share(text: string): string {
    return text.length > MAX_TEXT_CHARACTERS ? text : remembered(this.#texts, text, text);
  }

  /** Returns an equal list, the same one each time where it is short. Nobody may change it. */
  shareAll(texts: readonly string[]): string[] {
    const key = JSON.stringify(texts);
    const isShort = key.length <= MAX_TEXT_CHARACTERS;
    // Messages have lists that can be changed; devices are replaced as a whole.
    return (isShort ? remembered(this.#lists, key, texts) : texts) as string[];
  }
}

function remembered<T>(known: Map<string, T>, key: string, value: T): T {
  const before = known.get(key);
  if (before !== undefined) return before;
  if (known.size >= MAX_TEXTS) known.clear();
  known.set(key, value);
  return value;
}
