/** Most samples per second of the window. */
const MOMENTS_PER_S = 16;
/** Age from which samples are ignored, milliseconds. */
const WINDOW_MS = 2000;
/** Longer window for displayed rates, so that digits change less, milliseconds. */
export const SHOWN_WINDOW_MS = 4000;
/** Number of samples that count beyond the window, for slow events. */
const MIN_MOMENTS = 4;

/** Events, and when they were counted. */
interface Moment {
  readonly atMs: number;
  readonly events: number;
}

/** Measures the rate of events: what a sensor really delivers, not what was requested. */
export class RateMeter {
  readonly #moments: Moment[] = [];
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

  /** Counts events: one, or those since the last call of something that has a counter of its own. */
  note(nowMs: number, events = 1): void {
    const moments = this.#moments;
    moments.push({ atMs: nowMs, events });
    if (moments.length > (this.#windowMs / 1000) * MOMENTS_PER_S) moments.shift();
    const fromMs = nowMs - this.#windowMs;
    while (moments.length > MIN_MOMENTS && moments[0]!.atMs < fromMs) moments.shift();
  }

  /** Resets the measurement. */
  clear(): void {
    this.#moments.length = 0;
  }

  /** Events per second in the window; `undefined` after `staleMs` without one, and after the first one. */
  rateHz(nowMs: number): number | undefined {
    const [first, ...later] = this.#moments;
    const last = later.at(-1);
    if (first === undefined || last === undefined || last.atMs === first.atMs) return undefined;
    if (nowMs - last.atMs > this.#staleMs) return undefined;
    const events = later.reduce((sum, one) => sum + one.events, 0);
    return (events * 1000) / (last.atMs - first.atMs);
  }
}
