/** A jump of the publisher's clock larger than this starts over, milliseconds. */
const MAX_JUMP_MS = 5000;
/** How fast the estimate may follow a publisher whose clock runs slow: milliseconds per millisecond. */
const DRIFT = 0.001;

/**
 * Puts the moments a publisher wrote into its records on this machine's time axis. Records travel in
 * bundles, so their arrival says little about when values were taken; the fastest of them tells how
 * far the two clocks are apart.
 */
export class SampleClock {
  #offsetMs: number | undefined;
  #lastTimestampMs = 0;
  #lastArrivalMs = 0;

  /**
   * @param timestampMs publisher's clock; `undefined` when the record has none
   * @param arrivalMs this machine's clock
   * @returns when the value was taken, this machine's clock; never before the one before it
   */
  toLocalMs(timestampMs: number | undefined, arrivalMs: number): number {
    if (timestampMs === undefined) return arrivalMs;
    const offsetMs = arrivalMs - timestampMs;
    const hasJumped =
      this.#offsetMs === undefined ||
      timestampMs < this.#lastTimestampMs ||
      Math.abs(offsetMs - this.#offsetMs) > MAX_JUMP_MS;
    this.#offsetMs = hasJumped
      ? offsetMs
      : Math.min(offsetMs, this.#offsetMs! + DRIFT * (arrivalMs - this.#lastArrivalMs));
    this.#lastTimestampMs = timestampMs;
    this.#lastArrivalMs = arrivalMs;
    return timestampMs + this.#offsetMs;
  }
}
