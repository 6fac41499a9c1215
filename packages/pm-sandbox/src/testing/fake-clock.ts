import type { Cancel, Clock } from '../ports/clock.ts';

interface Timer {
  dueMs: number;
  readonly intervalMs: number | undefined;
  readonly fn: () => void;
}

/** A clock that moves only when told to, with turns of an event loop that end when told to. */
export class FakeClock implements Clock {
  readonly #epochMs: number;
  readonly #timers = new Set<Timer>();
  #elapsedMs = 0;
  #endOfTurn: (() => void)[] = [];

  /** @param epochMs what `nowMs` starts from. @default 2026-01-01T00:00:00Z */
  constructor(epochMs = Date.UTC(2026, 0, 1)) {
    this.#epochMs = epochMs;
  }

  nowMs(): number {
    return this.#epochMs + this.#elapsedMs;
  }

  monotonicMs(): number {
    return this.#elapsedMs;
  }

  every(intervalMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#elapsedMs + intervalMs, intervalMs, fn });
  }

  after(delayMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#elapsedMs + delayMs, intervalMs: undefined, fn });
  }

  atEndOfTurn(fn: () => void): void {
    this.#endOfTurn.push(fn);
  }

  /** Timers that are set: 0 when everything was cancelled. */
  get timerCount(): number {
    return this.#timers.size;
  }

  /** How many callbacks wait for the end of this turn. */
  get endOfTurnCount(): number {
    return this.#endOfTurn.length;
  }

  /** Ends this turn, with those that begin in it, and lets promises settle. */
  async endTurn(): Promise<void> {
    await settle();
    while (this.#endOfTurn.length > 0) {
      const fns = this.#endOfTurn;
      this.#endOfTurn = [];
      for (const fn of fns) fn();
      await settle();
    }
  }

  /** Ends the turn and lets time pass; every timer that is due then has a turn of its own. */
  async advance(durationMs: number): Promise<void> {
    await this.endTurn();
    const untilMs = this.#elapsedMs + durationMs;
    for (let next = this.#next(untilMs); next !== undefined; next = this.#next(untilMs)) {
      this.#elapsedMs = Math.max(this.#elapsedMs, next.dueMs);
      if (next.intervalMs === undefined) this.#timers.delete(next);
      else next.dueMs += next.intervalMs;
      next.fn();
      await this.endTurn();
    }
    this.#elapsedMs = untilMs;
  }

  /** Lets time pass within the turn, as a slow piece of work does; timers fire later. */
  spend(durationMs: number): void {
    this.#elapsedMs += durationMs;
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
    return () => void this.#timers.delete(timer);
  }
}

/** Resolves when every chain of promises under way has come to rest, or waits for something outside. */
export function settle(): Promise<void> {
  return new Promise((resolve) => setImmediate(resolve));
}
