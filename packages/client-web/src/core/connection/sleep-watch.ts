import type { Cancel, Clock } from '@ubii/timing';
import type { ClockReading } from '../time/clock-reading.ts';
import { readClocks } from '../time/clock-reading.ts';

/** Interval of clock checks, milliseconds: the longest delay in noticing a sleep. */
const LOOK_INTERVAL_MS = 500;
/** So much more than that has to have passed, milliseconds. Timers of hidden pages are a second late. */
const SLEPT_MS = 2_000;

/**
 * Notices that the machine slept, or that the page was frozen: no event tells all of that. The
 * monotonic clock stands still while most machines sleep, so the time of day counts as well. [CL-41]
 */
export class SleepWatch {
  readonly #clock: Clock;
  readonly #handleWake: () => void;
  #last: ClockReading | undefined;
  #cancel: Cancel | undefined;

  constructor(clock: Clock, handleWake: () => void) {
    this.#clock = clock;
    this.#handleWake = handleWake;
  }

  /** Starts to watch, unless it does. */
  start(): void {
    if (this.#cancel !== undefined) return;
    this.#last = readClocks(this.#clock);
    this.#cancel = this.#clock.every(LOOK_INTERVAL_MS, () => this.#look());
  }

  stop(): void {
    this.#cancel?.();
    this.#cancel = undefined;
  }

  #look(): void {
    const now = readClocks(this.#clock);
    const before = this.#last ?? now;
    this.#last = now;
    const passedMs = Math.max(now.monotonicMs - before.monotonicMs, now.wallMs - before.wallMs);
    if (passedMs > LOOK_INTERVAL_MS + SLEPT_MS) this.#handleWake();
  }
}
