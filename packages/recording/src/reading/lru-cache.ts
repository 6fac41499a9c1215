/** Keeps what was used last, up to a size. What is loaded twice at the same time is loaded once. */
export class LruCache<V> {
  readonly #entries = new Map<bigint, { readonly value: Promise<V>; bytes: number }>();
  readonly #maxBytes: number;
  #bytes = 0;

  constructor(maxBytes: number) {
    this.#maxBytes = maxBytes;
  }

  /** Returns the value of a key, from the cache or by `load`; failures are not kept. */
  get(key: bigint, bytes: number, load: () => Promise<V>): Promise<V> {
    const known = this.find(key);
    if (known !== undefined) return known;
    const value = load();
    this.#entries.set(key, { value, bytes });
    this.#bytes += bytes;
    value.catch(() => this.#remove(key));
    for (const oldest of this.#entries.keys()) {
      if (this.#bytes <= this.#maxBytes || oldest === key) break;
      this.#remove(oldest);
    }
    return value;
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
