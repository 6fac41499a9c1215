/** Age from which results no longer match a moving picture, milliseconds. */
export const MAX_LAG_MS = 300;
/** Age below which results are current again, milliseconds. */
const CALM_LAG_MS = 200;
/** Number of results for the median. */
const RESULTS = 5;
/** Age beyond `MAX_LAG_MS` at which a result has faded, milliseconds, and its final opacity. */
const FADE_MS = 700;
const FADED = 0.25;

/**
 * Age of results when the next one replaces them: the median of the last ones, so that a single late one has no effect.
 */
export class ResultLag {
  #newestMs: number | undefined;
  /** Ages of the last results, newest last, milliseconds. */
  #oldest: number[] = [];
  #isBehind = false;

  /**
   * Records the displayed result.
   *
   * @param takenMs capture time of the newest result's picture; undefined without a result
   * @param nowMs of the same clock
   */
  note(takenMs: number | undefined, nowMs: number): void {
    if (takenMs === undefined) return this.clear();
    if (takenMs !== this.#newestMs) this.#oldest = [...this.#oldest, 0].slice(-RESULTS);
    this.#newestMs = takenMs;
    this.#oldest.push(Math.max(this.#oldest.pop()!, nowMs - takenMs));
    this.#isBehind = this.medianMs > (this.#isBehind ? CALM_LAG_MS : MAX_LAG_MS);
  }

  /** True when results belong to an outdated picture. */
  get isBehind(): boolean {
    return this.#isBehind;
  }

  /** Median age, milliseconds; 0 without results. */
  get medianMs(): number {
    const sorted = this.#oldest.toSorted((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? 0;
  }

  clear(): void {
    this.#newestMs = undefined;
    this.#oldest = [];
    this.#isBehind = false;
  }
}

/** Opacity of a result over a picture that was taken this much later, 0 to 1. */
export function opacityAt(laterMs: number): number {
  const faded = (laterMs - MAX_LAG_MS) / FADE_MS;
  // Rounded, so that not every frame causes an update.
  return Math.max(FADED, Math.min(1, Math.round((1 - faded) * 20) / 20));
}
