const FIRST_CAPACITY = 1024;
/** Size of a number in memory, bytes. */
const NUMBER_BYTES = 8;

/** Series of numbers over time. NaN: no number at that time. */
export interface LinePoints {
  readonly size: number;
  /** Number of points ever pushed: the newest has this number, the oldest kept `pushed - size + 1`. */
  readonly pushed: number;
  /** @param index 0 is the oldest point */
  timeAt(index: number): number;
  valueAt(index: number): number;
  /** Index of the first point at or after a time; `size` when there is none. */
  indexAtOrAfter(timeMs: number): number;
}

/**
 * The newest points of several series with a common time axis, in typed arrays. Grows up to `maxPoints`, then drops the
 * oldest points.
 */
export class SeriesRing {
  #maxPoints: number;
  #capacity: number;
  #times: Float64Array;
  #columns: Float64Array[];
  /** Index of the next point to write. */
  #next = 0;
  #size = 0;
  #pushed = 0;

  /** @param lines initial number of series */
  constructor(lines: number, maxPoints: number) {
    this.#maxPoints = Math.max(1, Math.floor(maxPoints));
    this.#capacity = Math.min(FIRST_CAPACITY, this.#maxPoints);
    this.#times = new Float64Array(this.#capacity);
    this.#columns = Array.from({ length: lines }, () => new Float64Array(this.#capacity));
  }

  get lines(): number {
    return this.#columns.length;
  }

  get size(): number {
    return this.#size;
  }

  get pushed(): number {
    return this.#pushed;
  }

  get maxPoints(): number {
    return this.#maxPoints;
  }

  /** Allocated memory. */
  get bytes(): number {
    return (this.#columns.length + 1) * this.#capacity * NUMBER_BYTES;
  }

  /** @param timeMs earlier times are set to that of the last point */
  push(timeMs: number, numbers: readonly number[]): void {
    if (this.#size === this.#capacity && this.#capacity < this.#maxPoints) {
      this.#resize(Math.min(this.#capacity * 2, this.#maxPoints));
    }
    const last = this.#size === 0 ? -Infinity : this.timeAt(this.#size - 1);
    this.#times[this.#next] = Math.max(timeMs, last);
    for (let line = 0; line < this.#columns.length; line++) {
      this.#columns[line]![this.#next] = numbers[line] ?? Number.NaN;
    }
    this.#next = (this.#next + 1) % this.#capacity;
    this.#pushed++;
    if (this.#size < this.#capacity) this.#size++;
  }

  /** Adds a series, starting with the next point. @returns its index */
  addLine(): number {
    this.#columns.push(new Float64Array(this.#capacity).fill(Number.NaN));
    return this.#columns.length - 1;
  }

  /** Changes the limit; drops the oldest points at once. */
  setMaxPoints(maxPoints: number): void {
    this.#maxPoints = Math.max(1, Math.floor(maxPoints));
    if (this.#capacity <= this.#maxPoints) return;
    this.#size = Math.min(this.#size, this.#maxPoints);
    this.#resize(this.#maxPoints);
  }

  /** Drops the points before a time. */
  dropBefore(timeMs: number): void {
    this.#size -= this.indexAtOrAfter(timeMs);
  }

  /** @param index 0 is the oldest point */
  timeAt(index: number): number {
    return this.#times[this.#slot(index)]!;
  }

  valueAt(line: number, index: number): number {
    return this.#columns[line]![this.#slot(index)]!;
  }

  /** Index of the first point at or after a time; `size` when there is none. */
  indexAtOrAfter(timeMs: number): number {
    let [low, high] = [0, this.#size];
    while (low < high) {
      const middle = (low + high) >>> 1;
      if (this.timeAt(middle) < timeMs) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** Returns one of the series. */
  line(line: number): LinePoints {
    return new RingLine(this, line);
  }

  #slot(index: number): number {
    return (this.#next - this.#size + index + this.#capacity) % this.#capacity;
  }

  /** Requires `capacity` of at least the size; otherwise points would be lost. */
  #resize(capacity: number): void {
    const unrolled = (ring: Float64Array): Float64Array => {
      const copy = new Float64Array(capacity);
      for (let i = 0; i < this.#size; i++) copy[i] = ring[this.#slot(i)]!;
      return copy;
    };
    const times = unrolled(this.#times);
    const columns = this.#columns.map(unrolled);
    this.#next = this.#size % capacity;
    this.#capacity = capacity;
    this.#times = times;
    this.#columns = columns;
  }
}

class RingLine implements LinePoints {
  readonly #ring: SeriesRing;
  readonly #line: number;

  constructor(ring: SeriesRing, line: number) {
    this.#ring = ring;
    this.#line = line;
  }

  get size(): number {
    return this.#ring.size;
  }

  get pushed(): number {
    return this.#ring.pushed;
  }

  timeAt(index: number): number {
    return this.#ring.timeAt(index);
  }

  valueAt(index: number): number {
    return this.#ring.valueAt(this.#line, index);
  }

  indexAtOrAfter(timeMs: number): number {
    return this.#ring.indexAtOrAfter(timeMs);
  }
}
