/** Samples of a sparkline: 5 s at 8 a second. */
export const SPARK_SAMPLES = 40;
/** Another number takes over when it moves this much more than the one that is drawn. */
const TAKE_OVER = 1.5;
/** Less movement than this share of the value is noise and drawn as rest. */
const REST = 0.005;

/** A line and the scale it is drawn on. */
export interface SparkLine {
  /** Oldest first; `undefined` is a gap. */
  readonly values: readonly (number | undefined)[];
  readonly min: number | undefined;
  readonly max: number | undefined;
}

export const NO_SPARK: SparkLine = { values: [], min: undefined, max: undefined };

/**
 * The last seconds of a value as one line. Of a vector it shows the number that moves most, because
 * the length of a pointer that goes round in circles says nothing.
 */
export class Sparkline {
  #samples: (readonly number[] | undefined)[] = [];
  #number = 0;

  /** @param numbers of the value; `undefined` when nothing comes, which leaves a gap */
  add(numbers: readonly number[] | undefined): void {
    if (this.#samples.push(numbers) > SPARK_SAMPLES) this.#samples.shift();
  }

  clear(): void {
    this.#samples = [];
  }

  /** @param isActivity measured from 0, so that a steady rate is a steady line */
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
