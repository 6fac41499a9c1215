/** Length of a bucket, milliseconds: a value counts for one to two of them. */
const BUCKET_MS = 5000;

/**
 * Largest magnitude of the recent numbers of a series. Texts take their decimals from it, so that a value that passes
 * zero keeps its form.
 */
export class Reach {
  #startMs = -Infinity;
  #now = 0;
  #before = 0;

  get value(): number {
    return Math.max(this.#now, this.#before);
  }

  /** @param timeMs of any clock; an earlier time than before starts again */
  add(numbers: readonly number[], timeMs: number): void {
    if (timeMs < this.#startMs || timeMs >= this.#startMs + BUCKET_MS) {
      const isNext = timeMs >= this.#startMs && timeMs < this.#startMs + 2 * BUCKET_MS;
      this.#before = isNext ? this.#now : 0;
      this.#now = 0;
      this.#startMs = timeMs;
    }
    this.#now = Math.max(this.#now, reachOf(numbers));
  }
}

/** Returns the largest magnitude of finite numbers; 0 without one. */
export function reachOf(numbers: readonly (number | undefined)[]): number {
  let reach = 0;
  for (const number of numbers) {
    if (number !== undefined && Number.isFinite(number)) reach = Math.max(reach, Math.abs(number));
  }
  return reach;
}
