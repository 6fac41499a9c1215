/**
 * Longest time between two looks that counts, milliseconds. The engine looks about once a millisecond
 * while it computes; a longer gap means that the machine gave the thread no time, which is not the
 * module's fault. A single long step of the engine is left to the watchdog of the host.
 */
const MAX_GAP_MS = 25;
/** Time of a call from which its CPU time is measured, milliseconds: most calls end before, and pay nothing for it. */
const CPU_FROM_MS = 25;

/** Time of one call that is spent in the engine. */
export class TimeBudget {
  readonly #nowMs: () => number;
  readonly #cpuMs: (() => number) | undefined;
  #leftMs = 0;
  #lastMs = 0;
  /** Left of the call when its CPU time began to be measured, and the CPU time then. */
  #cpuFrom: { readonly leftMs: number; readonly cpuMs: number } | undefined;
  /** Left of the call when its CPU time is measured. */
  #cpuFromLeftMs = 0;
  #isRunning = false;
  /** True when the call was interrupted for its time. */
  isSpent = false;

  /**
   * @param cpuMs CPU time of the program, milliseconds, at least that of this thread. A call on a busy machine that has
   *   waited for a processor is not interrupted before that much was computed. Without it, only gaps are left out.
   */
  constructor(nowMs: () => number, cpuMs?: () => number) {
    this.#nowMs = nowMs;
    this.#cpuMs = cpuMs;
  }

  /** A new call begins. */
  begin(limitMs: number): void {
    this.#leftMs = limitMs;
    this.#cpuFrom = undefined;
    this.#cpuFromLeftMs = limitMs - CPU_FROM_MS;
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
    if (this.#cpuFrom === undefined && this.#leftMs < this.#cpuFromLeftMs && this.#cpuMs)
      this.#cpuFrom = { leftMs: this.#leftMs, cpuMs: this.#cpuMs() };
    if (this.#leftMs <= 0) this.#leftMs = this.#leftOfCpu();
    if (this.#leftMs <= 0) this.isSpent = true;
    return this.isSpent;
  }

  /** Returns what is left of the call by its CPU time, milliseconds. */
  #leftOfCpu(): number {
    if (this.#cpuFrom === undefined || this.#cpuMs === undefined) return 0;
    return this.#cpuFrom.leftMs - (this.#cpuMs() - this.#cpuFrom.cpuMs);
  }
}
