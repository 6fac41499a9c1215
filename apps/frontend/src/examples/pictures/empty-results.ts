/** Duration of empty results after which the source probably shows nothing that the module can find, milliseconds. */
export const EMPTY_MS = 8000;

/** Measures how long results are empty, by the timestamps of the pictures: time without results does not count. */
export class EmptyResults {
  #fromMs: number | undefined;
  #toMs = 0;

  /** @param atMs timestamp of the picture */
  note(isEmpty: boolean, atMs: number): void {
    if (!isEmpty) {
      this.clear();
      return;
    }
    this.#fromMs ??= atMs;
    this.#toMs = atMs;
  }

  clear(): void {
    this.#fromMs = undefined;
  }

  get isLong(): boolean {
    return this.#fromMs !== undefined && this.#toMs - this.#fromMs >= EMPTY_MS;
  }
}
