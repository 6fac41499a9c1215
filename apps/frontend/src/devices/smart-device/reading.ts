import { shallowRef } from 'vue';
import { RateMeter } from '../sensors/rate-meter.ts';

const LINE_POINTS = 30;

/** Displayed state of a sensor. */
export interface ShownReading<T> {
  /** `undefined` before the first value. */
  readonly value: T | undefined;
  /** Measured rate; `undefined` while no values arrive. */
  readonly rateHz: number | undefined;
  /** Recent values as one number each, oldest first. */
  readonly line: readonly number[];
}

/** Newest value of a sensor at its own rate, and its display at a lower rate. */
export class Reading<T> {
  readonly #shown = shallowRef<ShownReading<T>>({ value: undefined, rateHz: undefined, line: [] });
  readonly #meter = new RateMeter();
  readonly #measure: (value: T) => number;
  #newest: T | undefined;

  /** @param measure converts a value to a number for the chart */
  constructor(measure: (value: T) => number) {
    this.#measure = measure;
  }

  /** @returns the value */
  note(value: T, nowMs: number): T {
    this.#newest = value;
    this.#meter.note(nowMs);
    return value;
  }

  /** Updates the display. */
  show(nowMs: number): void {
    const rateHz = this.#meter.rateHz(nowMs);
    const { value: shownValue, rateHz: shownRate, line } = this.#shown.value;
    if (this.#newest === undefined || (rateHz === undefined && shownRate === undefined)) {
      // No new value: the display is up to date; but the first value has no rate yet.
      if (this.#newest === shownValue) return;
    }
    const value = this.#newest as T;
    this.#shown.value = {
      value,
      rateHz,
      line: [...line.slice(1 - LINE_POINTS), this.#measure(value)],
    };
  }

  get shown(): ShownReading<T> {
    return this.#shown.value;
  }
}
