/** Older results do not fit a picture that moves on, milliseconds. */
export const MAX_LAG_MS = 300;
/** Results are current again when they become no older than this, milliseconds. */
const CALM_LAG_MS = 200;
/** Results that count. */
const RESULTS = 5;
/** A result this much older than `MAX_LAG_MS` has faded, milliseconds, to this opacity. */
const FADE_MS = 700;
const FADED = 0.25;

/**
 * How old results become on the screen before the next one replaces them: the median of the last ones, so that a single late one
 * changes nothing.
 */
export class ResultLag {
  #newestMs: number | undefined;
  /** Of the last results, the newest last, milliseconds. */
  #oldest: number[] = [];
  #isBehind = false;

  /**
   * Notes what is on the screen now.
   *
   * @param takenMs when the picture of the newest result was taken; undefined without a result
   * @param nowMs on the same clock
   */
  note(takenMs: number | undefined, nowMs: number): void {
    if (takenMs === undefined) return this.clear();
    if (takenMs !== this.#newestMs) this.#oldest = [...this.#oldest, 0].slice(-RESULTS);
    this.#newestMs = takenMs;
    this.#oldest.push(Math.max(this.#oldest.pop()!, nowMs - takenMs));
    this.#isBehind = this.medianMs > (this.#isBehind ? CALM_LAG_MS : MAX_LAG_MS);
  }

  /** Results are those of a picture that is over. */
  get isBehind(): boolean {
    return this.#isBehind;
  }

  /** Milliseconds; 0 without results. */
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

/** How much is seen of a result over a picture that was taken so much later, 0 to 1. */
export function opacityAt(laterMs: number): number {
  const faded = (laterMs - MAX_LAG_MS) / FADE_MS;
  // In steps, so that not every frame is a new one.
  return Math.max(FADED, Math.min(1, Math.round((1 - faded) * 20) / 20));
}
