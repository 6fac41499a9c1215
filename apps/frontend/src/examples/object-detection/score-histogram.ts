/** Number of bars from a score of 0 to a score of 1. */
export const SCORE_BARS = 40;
/** Length of the window, seconds. */
const WINDOW_S = 10;

/** Histogram of the scores of the last ten seconds; its memory does not grow with the number of scores. */
export class ScoreHistogram {
  /** Counts per second, oldest first. */
  #seconds: { readonly at: number; readonly bars: number[] }[] = [];

  /** @param scores 0 to 1 */
  add(scores: readonly number[], nowMs: number): void {
    const at = Math.floor(nowMs / 1000);
    let last = this.#seconds.at(-1);
    if (last?.at !== at) {
      last = { at, bars: new Array<number>(SCORE_BARS).fill(0) };
      this.#seconds.push(last);
    }
    for (const score of scores) {
      if (!(score >= 0 && score <= 1)) continue;
      last.bars[Math.min(SCORE_BARS - 1, Math.floor(score * SCORE_BARS))]! += 1;
    }
    this.#forget(at);
  }

  /**
   * Returns the heights of the bars relative to the highest, as square roots, so that rare scores are visible beside
   * frequent ones.
   */
  heights(nowMs: number): number[] {
    this.#forget(Math.floor(nowMs / 1000));
    const sums = Array.from({ length: SCORE_BARS }, (_, bar) =>
      this.#seconds.reduce((sum, { bars }) => sum + bars[bar]!, 0),
    );
    const most = Math.max(1, ...sums);
    return sums.map((sum) => Math.sqrt(sum / most));
  }

  clear(): void {
    this.#seconds = [];
  }

  #forget(at: number): void {
    this.#seconds = this.#seconds.filter((one) => at - one.at < WINDOW_S);
  }
}
