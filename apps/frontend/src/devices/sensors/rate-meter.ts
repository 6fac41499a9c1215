/** How many moments are looked at. */
const MOMENTS = 32;

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
    this.#atMs.push(nowMs);
    if (this.#atMs.length > MOMENTS) this.#atMs.shift();
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
