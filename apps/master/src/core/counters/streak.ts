/** Time after the last failure for which a series of failures counts as ongoing, milliseconds. [EX-18] */
const STANDS_MS = 30_000;

/** Mishaps in a row: how many, and since when. Times are monotonic milliseconds. */
export class Streak {
  count = 0;
  /** When the present row, or the last one, began. */
  sinceMs = 0;
  #lastMs: number | undefined = undefined;

  /** Counts one more. Returns true when a new row begins with it. */
  add(nowMs: number): boolean {
    const isNew = !this.isOn(nowMs);
    if (isNew) this.sinceMs = nowMs;
    this.#lastMs = nowMs;
    this.count++;
    return isNew;
  }

  /** Whether a row is going on. */
  isOn(nowMs: number): boolean {
    return this.#lastMs !== undefined && nowMs - this.#lastMs <= STANDS_MS;
  }
}
