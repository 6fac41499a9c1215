import type { Cancel, Clock } from '../core/ports/clock.ts';

interface Timer {
  dueMs: number;
  readonly intervalMs: number | undefined;
  readonly fn: () => void;
}

/** A clock that stands still until told otherwise, with turns that end when told to. */
export class FakeClock implements Clock {
  #nowMs: number;
  #startMs: number;
  #timers = new Set<Timer>();
  #endOfTurn: (() => void)[] = [];

  /** @param startMs Epoch milliseconds at which it stands; default 2026-01-01T00:00:00Z. */
  constructor(startMs = Date.UTC(2026, 0, 1)) {
    this.#nowMs = startMs;
    this.#startMs = startMs;
  }

  nowMs(): number {
    return this.#nowMs;
  }

  preciseMs(): number {
    return this.#nowMs;
  }

  monotonicMs(): number {
    return this.#nowMs - this.#startMs;
  }

  every(intervalMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#nowMs + intervalMs, intervalMs, fn });
  }

  after(delayMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#nowMs + delayMs, intervalMs: undefined, fn });
  }

  atEndOfTurn(fn: () => void): void {
    this.#endOfTurn.push(fn);
  }

  /** Timers that are set. */
  get timerCount(): number {
    return this.#timers.size;
  }

  /** Ends this turn of the event loop. */
  endTurn(): void {
    while (this.#endOfTurn.length > 0) {
      const fns = this.#endOfTurn;
      this.#endOfTurn = [];
      for (const fn of fns) fn();
    }
  }

  /** Ends the turn, and lets time pass; every timer that is due has a turn of its own. */
  advance(durationMs: number): void {
    this.endTurn();
    const untilMs = this.#nowMs + durationMs;
    for (;;) {
      const next = this.#next(untilMs);
      if (next === undefined) break;
      this.#nowMs = Math.max(this.#nowMs, next.dueMs);
      if (next.intervalMs === undefined) this.#timers.delete(next);
      else next.dueMs += next.intervalMs;
      next.fn();
      this.endTurn();
    }
    this.#nowMs = untilMs;
  }

  /** Lets time pass without a turn: what a slow piece of work does. */
  spend(durationMs: number): void {
    this.#nowMs += durationMs;
  }

  #next(untilMs: number): Timer | undefined {
    let next: Timer | undefined;
    for (const timer of this.#timers) {
      if (timer.dueMs <= untilMs && (next === undefined || timer.dueMs < next.dueMs)) next = timer;
    }
    return next;
  }

  #add(timer: Timer): Cancel {
    this.#timers.add(timer);
    return () => this.#timers.delete(timer);
  }
}
