import { shallowRef } from 'vue';
import { RateMeter } from '../sensors/rate-meter.ts';

const LINE_POINTS = 30;

/** What a person sees of a sensor. */
export interface ShownReading<T> {
  /** `undefined` before the first. */
  readonly value: T | undefined;
  /** As measured; `undefined` when nothing comes now. */
  readonly rateHz: number | undefined;
  /** The last moments as one number each, oldest first. */
  readonly line: readonly number[];
}

/** A sensor's newest value, at the sensor's rate, and what of it is shown, at a calmer one. */
export class Reading<T> {
  readonly #shown = shallowRef<ShownReading<T>>({ value: undefined, rateHz: undefined, line: [] });
  readonly #meter = new RateMeter();
  readonly #measure: (value: T) => number;
  #newest: T | undefined;

  /** @param measure makes a value one number, for the line */
  constructor(measure: (value: T) => number) {
    this.#measure = measure;
  }

  /** @returns the value, to be passed on */
  note(value: T, nowMs: number): T {
    this.#newest = value;
    this.#meter.note(nowMs);
    return value;
  }

  /** Renews what is shown. */
  show(nowMs: number): void {
    const rateHz = this.#meter.rateHz(nowMs);
    const { value: shownValue, rateHz: shownRate, line } = this.#shown.value;
    if (this.#newest === undefined || (rateHz === undefined && shownRate === undefined)) {
      // Nothing comes, and that is what is shown; but a first value has no rate yet.
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
