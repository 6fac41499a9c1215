/** How many moments are looked at in each second of the window, at most. */
const MOMENTS_PER_S = 16;
/** Older moments say nothing of now, milliseconds. */
const WINDOW_MS = 2000;
/** Of rates that people read: fewer digits that dance, milliseconds. */
export const SHOWN_WINDOW_MS = 4000;
/** So many of what happens seldom count for longer. */
const MIN_MOMENTS = 4;

/** How often something happens, as measured: what a sensor really delivers, not what was asked for. */
export class RateMeter {
  readonly #atMs: number[] = [];
  readonly #staleMs: number;
  readonly #windowMs: number;

  /**
   * @param staleMs without anything for this long, nothing comes any more, milliseconds
   * @param windowMs what is older does not count, milliseconds
   */
  constructor(staleMs = 1000, windowMs = WINDOW_MS) {
    this.#staleMs = staleMs;
    this.#windowMs = windowMs;
  }

  /** It happened. */
  note(nowMs: number): void {
    const moments = this.#atMs;
    moments.push(nowMs);
    if (moments.length > (this.#windowMs / 1000) * MOMENTS_PER_S) moments.shift();
    while (moments.length > MIN_MOMENTS && moments[0]! < nowMs - this.#windowMs) moments.shift();
  }

  /** Forgets what was: something else is measured from now on. */
  clear(): void {
    this.#atMs.length = 0;
  }

  /** Times a second over the last moments; `undefined` when it does not happen now, or did once only. */
  rateHz(nowMs: number): number | undefined {
    const first = this.#atMs[0];
    const last = this.#atMs.at(-1);
    if (first === undefined || last === undefined || nowMs - last > this.#staleMs) return undefined;
    if (last === first) return undefined;
    return ((this.#atMs.length - 1) * 1000) / (last - first);
  }
}
