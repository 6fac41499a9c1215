/** Keeps what comes, and lets a test wait for it. */
export class Inbox<T> {
  readonly all: T[] = [];
  readonly #waiting = new Set<() => void>();

  add(item: T): void {
    this.all.push(item);
    for (const look of [...this.#waiting]) look();
  }

  /** Resolves with the first item that fits, also one that came before. Takes it, and what came before it, away. */
  next(fits: (item: T) => boolean = () => true): Promise<T> {
    return new Promise((resolve) => {
      const look = (): void => {
        const index = this.all.findIndex(fits);
        if (index < 0) return;
        this.#waiting.delete(look);
        const [found] = this.all.splice(0, index + 1).slice(-1);
        resolve(found!);
      };
      this.#waiting.add(look);
      look();
    });
  }
}
