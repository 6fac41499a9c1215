import type { Cancel, Clock } from '@ubii/timing';

interface Timer {
  dueMs: number;
  readonly intervalMs: number | undefined;
  readonly run: () => void;
}

/** A clock that stands still until it is moved, for recorded time. */
export class SteppedClock implements Clock {
  readonly #startMs: number;
  readonly #timers = new Set<Timer>();
  #elapsedMs = 0;

  /** @param startMs time of day at its beginning, milliseconds since the Unix epoch */
  constructor(startMs: number) {
    this.#startMs = startMs;
  }

  nowMs(): number {
    return this.#startMs + this.#elapsedMs;
  }

  /** Since its beginning. */
  monotonicMs(): number {
    return this.#elapsedMs;
  }

  every(intervalMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#elapsedMs + intervalMs, intervalMs, run: fn });
  }

  after(delayMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#elapsedMs + delayMs, intervalMs: undefined, run: fn });
  }

  atEndOfTurn(fn: () => void): void {
    queueMicrotask(fn);
  }

  /**
   * Moves to a moment and calls the timers on the way, each at its time.
   *
   * @param rest waits until what a timer began has ended
   */
  async moveTo(elapsedMs: number, rest: () => Promise<void>): Promise<void> {
    for (;;) {
      const due = [...this.#timers].filter(({ dueMs }) => dueMs <= elapsedMs);
      const next = due.sort((a, b) => a.dueMs - b.dueMs)[0];
      if (next === undefined) break;
      this.#elapsedMs = Math.max(this.#elapsedMs, next.dueMs);
      if (next.intervalMs === undefined) this.#timers.delete(next);
      else next.dueMs += next.intervalMs;
      next.run();
      await rest();
    }
    this.#elapsedMs = Math.max(this.#elapsedMs, elapsedMs);
  }

  #add(timer: Timer): Cancel {
    this.#timers.add(timer);
    return () => void this.#timers.delete(timer);
  }
}
