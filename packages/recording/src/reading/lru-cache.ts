/** Keeps what was used last, up to a size. What is loaded twice at the same time is loaded once. */
export class LruCache<V> {
  readonly #entries = new Map<bigint, { readonly value: Promise<V>; bytes: number }>();
  readonly #maxBytes: number;
  #bytes = 0;

  constructor(maxBytes: number) {
    this.#maxBytes = maxBytes;
  }

  /**
   * Returns the value of a key, from the cache or by `load`; failures are not kept.
   *
   * @param more bytes that a loaded value takes besides. @default none
   */
  get(
    key: bigint,
    bytes: number,
    load: () => Promise<V>,
    more: (value: V) => number = () => 0,
  ): Promise<V> {
    const known = this.find(key);
    if (known !== undefined) return known;
    const value = load();
    const entry = { value, bytes: 0 };
    this.#entries.set(key, entry);
    const grow = (added: number): void => {
      if (this.#entries.get(key) !== entry) return;
      entry.bytes += added;
      this.#bytes += added;
      this.#evict(key);
    };
    grow(bytes);
    value.then(
      (loaded) => grow(more(loaded)),
      () => this.#remove(key),
    );
    return value;
  }

  /** @param newest stays, however large it is */
  #evict(newest: bigint): void {
    for (const oldest of this.#entries.keys()) {
      if (this.#bytes <= this.#maxBytes || oldest === newest) return;
      this.#remove(oldest);
    }
  }

  has(key: bigint): boolean {
    return this.#entries.has(key);
  }

  /** Returns the value of a key, and counts as its use; undefined when it is not kept. */
  find(key: bigint): Promise<V> | undefined {
    const known = this.#entries.get(key);
    if (known === undefined) return undefined;
    this.#entries.delete(key);
    this.#entries.set(key, known);
    return known.value;
  }

  #remove(key: bigint): void {
    this.#bytes -= this.#entries.get(key)?.bytes ?? 0;
    this.#entries.delete(key);
  }
}
