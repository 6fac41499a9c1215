import type { Cancel, TurnTask } from '@ubii/timing';
import type { ModeDriver, RunHost } from './mode-driver.ts';

/**
 * Runs at the start, then at fixed moments: the multiples of its interval on the clock of the node,
 * whatever happened to the runs before. Instances of one frequency have the same moments, so that
 * many of them cost one wake-up and one message. [PM-21] [PM-22]
 */
export class FrequencyDriver implements ModeDriver, TurnTask {
  readonly #host: RunHost;
  readonly #intervalMs: number;
  /** Multiple of the interval that the timer waits for. */
  #next = 0;
  #cancel: Cancel | undefined;
  /** Waits for the end of a run that is late. */
  #isOverrun = false;

  constructor(host: RunHost, hertz: number) {
    this.#host = host;
    this.#intervalMs = 1000 / hertz;
  }

  get waiting(): number {
    return 0;
  }

  start(): void {
    this.stop();
    // The nearest one: between the first two runs there is at least half an interval.
    this.#next = Math.round(this.#host.monotonicMs() / this.#intervalMs);
    // A run of another mode may be in progress; this does not count as an overrun.
    if (this.#host.isBusy) this.#wait();
    else this.#handleDue();
  }

  stop(): void {
    this.#cancel?.();
    this.#cancel = undefined;
    this.#isOverrun = false;
  }

  handleRunEnd(): void {
    if (!this.#isOverrun) return;
    this.#isOverrun = false;
    this.#wait();
  }

  handleMark(): void {}

  readonly #handleDue = (): void => {
    this.#cancel = undefined;
    if (this.#host.isBusy) {
      this.#isOverrun = true;
      this.#host.countOverrun(this.#intervalMs);
      return;
    }
    this.#wait();
    this.#host.atEndOfTurn(this);
  };

  /** Instances that are due at the same moment start together: what they send travels together. */
  handleEndOfTurn(): void {
    const isStopped = this.#cancel === undefined;
    if (!isStopped && !this.#host.isBusy) this.#host.run();
  }

  /** Sets the timer for the first run that is due after now. */
  #wait(): void {
    const nowMs = this.#host.monotonicMs();
    // Timers may fire a little early; the run they were set for is not due again then.
    const least = this.#next + 1;
    const passed = Math.floor(nowMs / this.#intervalMs);
    let next = Math.max(least, passed);
    while (this.#dueMs(next) <= nowMs) next++;
    this.#next = next;
    this.#cancel = this.#host.after(this.#dueMs(next) - nowMs, this.#handleDue);
  }

  #dueMs(run: number): number {
    return run * this.#intervalMs;
  }
}
