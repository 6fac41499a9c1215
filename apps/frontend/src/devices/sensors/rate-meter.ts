/** How many moments are looked at, at most. */
const MOMENTS = 32;
/** Older moments say nothing of now, milliseconds. */
const WINDOW_MS = 2000;
/** So many of what happens seldom count for longer. */
const MIN_MOMENTS = 4;

/** How often something happens, as measured: what a sensor really delivers, not what was asked for. */
export class RateMeter {
  readonly #atMs: number[] = [];
  readonly #staleMs: number;

  /** @param staleMs without anything for this long, nothing comes any more, milliseconds */
  constructor(staleMs = 1000) {
    this.#staleMs = staleMs;
  }

  /** It happened. */
  note(nowMs: number): void {
    const moments = this.#atMs;
    moments.push(nowMs);
    if (moments.length > MOMENTS) moments.shift();
    while (moments.length > MIN_MOMENTS && moments[0]! < nowMs - WINDOW_MS) moments.shift();
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
