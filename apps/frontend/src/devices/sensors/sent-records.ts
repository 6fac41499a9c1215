const LINE_SAMPLES = 30;

/** Current rate of sent records, and its last samples. */
export interface SentRate {
  readonly perSecond: number;
  /** Records per second of each sample, oldest first. */
  readonly line: readonly number[];
}

/** Counts the records that a device sends. */
export class SentRecords {
  #count = 0;
  #sampledMs: number;
  #line: readonly number[] = [];

  constructor(nowMs: number) {
    this.#sampledMs = nowMs;
  }

  /** Counts a record. */
  note(): void {
    this.#count += 1;
  }

  /** Returns the rate since the previous sample. */
  sample(nowMs: number): SentRate {
    const perSecond = (this.#count * 1000) / Math.max(1, nowMs - this.#sampledMs);
    this.#count = 0;
    this.#sampledMs = nowMs;
    this.#line = [...this.#line.slice(1 - LINE_SAMPLES), perSecond];
    return { perSecond, line: this.#line };
  }
}
