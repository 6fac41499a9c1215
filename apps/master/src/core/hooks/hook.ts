/** Callbacks for one kind of event of a part, added by areas that are created after it. */
export class Hook<T extends readonly unknown[]> {
  readonly #listeners: ((...facts: T) => void)[] = [];

  /** Listeners are called in the order in which they were added. */
  add(listener: (...facts: T) => void): void {
    this.#listeners.push(listener);
  }

  emit(...facts: T): void {
    for (const listener of this.#listeners) listener(...facts);
  }
}
