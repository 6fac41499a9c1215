/**
 * Longest time between two looks that counts, milliseconds. The engine looks about once a millisecond
 * while it computes; a longer gap means that the machine gave the thread no time, which is not the
 * module's fault. A single long step of the engine is left to the watchdog of the host.
 */
const MAX_GAP_MS = 25;

/** Time of one call that is spent in the engine. */
export class TimeBudget {
  readonly #nowMs: () => number;
  #leftMs = 0;
  #lastMs = 0;
  #isRunning = false;
  /** True when the call was interrupted for its time. */
  isSpent = false;

  constructor(nowMs: () => number) {
    this.#nowMs = nowMs;
  }

  /** A new call begins. */
  begin(limitMs: number): void {
    this.#leftMs = limitMs;
    this.isSpent = false;
  }

  /** The engine goes on, for the call under way. */
  enter(): void {
    this.#lastMs = this.#nowMs();
    this.#isRunning = true;
  }

  /** The engine came back. */
  leave(): void {
    this.look();
    this.#isRunning = false;
  }

  /** True when the engine is to stop. */
  look(): boolean {
    if (!this.#isRunning) return false;
    const now = this.#nowMs();
    this.#leftMs -= Math.min(now - this.#lastMs, MAX_GAP_MS);
    this.#lastMs = now;
    if (this.#leftMs < 0) this.isSpent = true;
    return this.isSpent;
  }
}
