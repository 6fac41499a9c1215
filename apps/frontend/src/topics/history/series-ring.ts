const FIRST_CAPACITY = 1024;
/** Points kept: a minute at 1 kHz. */
export const MAX_POINTS = 65_536;

/**
 * The newest points of some lines over one time axis, in memory that is set aside once. Grows up to
 * `MAX_POINTS`, then the oldest point makes room.
 */
export class SeriesRing {
  readonly lines: number;
  #capacity = FIRST_CAPACITY;
  #times = new Float64Array(FIRST_CAPACITY);
  /** Line after line, each of `#capacity`. */
  #values: Float64Array;
  /** Where the next point goes. */
  #next = 0;
  #size = 0;

  /** @param lines how many numbers a point has */
  constructor(lines: number) {
    this.lines = lines;
    this.#values = new Float64Array(lines * FIRST_CAPACITY);
  }

  get size(): number {
    return this.#size;
  }

  /** @param timeMs not before the last point's; a point that claims to be is put beside it */
  push(timeMs: number, numbers: readonly number[]): void {
    if (this.#size === this.#capacity && this.#capacity < MAX_POINTS) this.#grow();
    const last = this.#size === 0 ? -Infinity : this.timeAt(this.#size - 1);
    this.#times[this.#next] = Math.max(timeMs, last);
    for (let line = 0; line < this.lines; line++) {
      this.#values[line * this.#capacity + this.#next] = numbers[line] ?? Number.NaN;
    }
    this.#next = (this.#next + 1) % this.#capacity;
    if (this.#size < this.#capacity) this.#size++;
  }

  /** @param index 0 is the oldest point */
  timeAt(index: number): number {
    return this.#times[this.#slot(index)]!;
  }

  valueAt(line: number, index: number): number {
    return this.#values[line * this.#capacity + this.#slot(index)]!;
  }

  /** The first point at or after a moment; `size` when there is none. */
  indexAtOrAfter(timeMs: number): number {
    let [low, high] = [0, this.#size];
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.timeAt(middle) < timeMs) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #slot(index: number): number {
    return (this.#next - this.#size + index + this.#capacity) % this.#capacity;
  }

  #grow(): void {
    const capacity = this.#capacity * 2;
    const times = new Float64Array(capacity);
    const values = new Float64Array(this.lines * capacity);
    for (let i = 0; i < this.#size; i++) {
      times[i] = this.timeAt(i);
      for (let line = 0; line < this.lines; line++) {
        values[line * capacity + i] = this.valueAt(line, i);
      }
    }
    this.#next = this.#size;
    this.#capacity = capacity;
    this.#times = times;
    this.#values = values;
  }
}
