/** What arrives, kept until it is read. */
export class Inbox<T> {
  readonly waiting: T[] = [];
  #wake: () => void = () => undefined;

  add(one: T): void {
    this.waiting.push(one);
    this.#wake();
  }

  async next(): Promise<T> {
    for (;;) {
      const one = this.waiting.shift();
      if (one !== undefined) return one;
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }
}
