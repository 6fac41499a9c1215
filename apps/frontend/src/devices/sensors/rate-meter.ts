/** Most samples per second of the window. */
const MOMENTS_PER_S = 16;
/** Age from which samples are ignored, milliseconds. */
const WINDOW_MS = 2000;
/** Longer window for displayed rates, so that digits change less, milliseconds. */
export const SHOWN_WINDOW_MS = 4000;
/** Number of samples that count beyond the window, for slow events. */
const MIN_MOMENTS = 4;

/** Measures the rate of events: what a sensor really delivers, not what was requested. */
export class RateMeter {
  readonly #atMs: number[] = [];
  readonly #staleMs: number;
  readonly #windowMs: number;

  /**
   * @param staleMs silence after which the rate is unknown, milliseconds
   * @param windowMs length of the window, milliseconds
   */
  constructor(staleMs = 1000, windowMs = WINDOW_MS) {
    this.#staleMs = staleMs;
    this.#windowMs = windowMs;
  }

  /** Counts an event. */
  note(nowMs: number): void {
    const moments = this.#atMs;
    moments.push(nowMs);
    if (moments.length > (this.#windowMs / 1000) * MOMENTS_PER_S) moments.shift();
    while (moments.length > MIN_MOMENTS && moments[0]! < nowMs - this.#windowMs) moments.shift();
  }

  /** Resets the measurement. */
  clear(): void {
    this.#atMs.length = 0;
  }

  /** Events per second in the window; `undefined` after `staleMs` without one, and after the first one. */
  rateHz(nowMs: number): number | undefined {
    const first = this.#atMs[0];
    const last = this.#atMs.at(-1);
    if (first === undefined || last === undefined || nowMs - last > this.#staleMs) return undefined;
    if (last === first) return undefined;
    return ((this.#atMs.length - 1) * 1000) / (last - first);
  }
}
