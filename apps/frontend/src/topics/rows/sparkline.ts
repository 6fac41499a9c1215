/** Number of samples: 5 s at 8 a second. */
export const SPARK_SAMPLES = 40;
/** Factor by which another number must vary more than the current one to replace it. */
const TAKE_OVER = 1.5;
/** Smallest variation that is drawn, as a share of the value; less is noise. */
const REST = 0.005;

/** Chart with its scale. */
export interface SparkLine {
  /** Oldest first; `undefined` is a gap. */
  readonly values: readonly (number | undefined)[];
  readonly min: number | undefined;
  readonly max: number | undefined;
}

export const NO_SPARK: SparkLine = { values: [], min: undefined, max: undefined };

/**
 * Chart of the last seconds of a value. For a vector, draws the number that varies most: the length of a pointer that
 * moves in circles says nothing.
 */
export class Sparkline {
  #samples: (readonly number[] | undefined)[] = [];
  #number = 0;

  /** @param numbers of the value; `undefined` adds a gap */
  add(numbers: readonly number[] | undefined): void {
    if (this.#samples.push(numbers) > SPARK_SAMPLES) this.#samples.shift();
  }

  clear(): void {
    this.#samples = [];
  }

  /** @param isActivity scaled from 0, so that a steady rate is a flat line */
  line(isActivity: boolean): SparkLine {
    const width = Math.max(0, ...this.#samples.map((numbers) => numbers?.length ?? 0));
    if (width === 0) return NO_SPARK;
    const spans = Array.from({ length: width }, (_, number) => this.#spanOf(number));
    const most = spans.reduce((best, span, i) => (span.size > spans[best]!.size ? i : best), 0);
    const drawn = spans[this.#number]?.size ?? -1;
    if (drawn < 0 || spans[most]!.size > TAKE_OVER * drawn) this.#number = most;
    const { min, max, size } = spans[this.#number]!;
    const values = this.#samples.map((numbers) => finite(numbers?.[this.#number]));
    if (isActivity) return { values, min: 0, max: undefined };
    const rest = REST * Math.max(Math.abs(min), Math.abs(max));
    if (size < 0 || size >= rest) return { values, min: undefined, max: undefined };
    return { values, min: (min + max) / 2 - rest, max: (min + max) / 2 + rest };
  }

  #spanOf(number: number): { min: number; max: number; size: number } {
    let [min, max] = [Infinity, -Infinity];
    for (const numbers of this.#samples) {
      const value = finite(numbers?.[number]);
      if (value === undefined) continue;
      if (value < min) min = value;
      if (value > max) max = value;
    }
    return { min, max, size: max - min };
  }
}

const finite = (value: number | undefined): number | undefined =>
  value !== undefined && Number.isFinite(value) ? value : undefined;
