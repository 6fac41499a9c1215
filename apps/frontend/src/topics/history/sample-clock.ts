/** Largest jump of the publisher's clock before the estimate is reset, milliseconds. */
const MAX_JUMP_MS = 5000;
/** Rate at which the estimate follows a slow publisher's clock: milliseconds per millisecond. */
const DRIFT = 0.001;

/**
 * Converts timestamps of a publisher to this computer's clock. Records arrive in batches, so arrival times say little
 * about measurement times; the record with the shortest delay gives the offset of the two clocks.
 */
export class SampleClock {
  #offsetMs: number | undefined;
  #lastTimestampMs = 0;
  #lastArrivalMs = 0;

  /**
   * @param timestampMs publisher's clock; `undefined` when the record has none
   * @param arrivalMs this computer's clock
   * @returns time of measurement, this computer's clock; never before the previous one
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
