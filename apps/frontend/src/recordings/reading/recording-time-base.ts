const NS_PER_MS = 1_000_000;

/** Converts times of a file, nanoseconds since the Unix epoch, to milliseconds since its beginning and back. */
export class TimeBase {
  readonly #startNs: bigint;

  constructor(startNs: bigint) {
    this.#startNs = startNs;
  }

  toMs(timeNs: bigint): number {
    return Number(timeNs - this.#startNs) / NS_PER_MS;
  }

  toNs(timeMs: number): bigint {
    return this.#startNs + BigInt(Math.round(timeMs * NS_PER_MS));
  }

  /** Milliseconds since the Unix epoch. */
  get startMs(): number {
    return Number(this.#startNs) / NS_PER_MS;
  }

  /** Where a time lies in the recording. @param epochMs milliseconds since the Unix epoch */
  placed(epochMs: number): number {
    return epochMs - this.startMs;
  }
}
