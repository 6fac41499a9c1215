import type { Cancel, PreciseClock } from '../clock.ts';

interface Timer {
  dueMs: number;
  readonly intervalMs: number | undefined;
  readonly fn: () => void;
}

/**
 * A clock that moves only when told to, with turns of an event loop that end when told to. Methods that
 * end in `Sync` run callbacks alone; the others let promises settle before and after each.
 */
export class FakeClock implements PreciseClock {
  #epochMs: number;
  #elapsedMs = 0;
  readonly #timers = new Set<Timer>();
  #endOfTurn: (() => void)[] = [];

  /** @param epochMs what `nowMs` starts from. @default 2026-01-01T00:00:00Z */
  constructor(epochMs = Date.UTC(2026, 0, 1)) {
    this.#epochMs = epochMs;
  }

  nowMs(): number {
    return this.#epochMs + this.#elapsedMs;
  }

  preciseMs(): number {
    return this.nowMs();
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

  /** Number of callbacks that wait for the end of this turn. */
  get endOfTurnCount(): number {
    return this.#endOfTurn.length;
  }

  /** Ends this turn, with those that begin in it, and lets promises settle. */
  async endTurn(): Promise<void> {
    await settle();
    while (this.#runEndOfTurn()) await settle();
  }

  /** Ends this turn, with those that begin in it. */
  endTurnSync(): void {
    while (this.#runEndOfTurn());
  }

  /** Ends the turn and lets time pass; every timer that is due then has a turn of its own. */
  async advance(durationMs: number): Promise<void> {
    await this.endTurn();
    const untilMs = this.#elapsedMs + durationMs;
    while (this.#runTimer(untilMs)) await this.endTurn();
    this.#elapsedMs = Math.max(this.#elapsedMs, untilMs);
  }

  /** As `advance`, without waiting for promises. */
  advanceSync(durationMs: number): void {
    this.endTurnSync();
    const untilMs = this.#elapsedMs + durationMs;
    while (this.#runTimer(untilMs)) this.endTurnSync();
    this.#elapsedMs = Math.max(this.#elapsedMs, untilMs);
  }

  /** Lets time pass within the turn, as a slow piece of work does; timers fire later. */
  spend(durationMs: number): void {
    this.#elapsedMs += durationMs;
  }

  /** Timers stand still for so long, then what fell due is called once, too late: a page that was frozen. */
  async sleep(durationMs: number): Promise<void> {
    this.#elapsedMs += durationMs;
    for (const timer of this.#timers) {
      if (timer.intervalMs !== undefined) timer.dueMs = Math.max(timer.dueMs, this.#elapsedMs);
    }
    await this.advance(0);
  }

  /** Sets the time of day: forwards it is also what a machine sees that slept so long. */
  setWall(byMs: number): void {
    this.#epochMs += byMs;
  }

  /** Returns whether there was something to run. */
  #runEndOfTurn(): boolean {
    const fns = this.#endOfTurn;
    this.#endOfTurn = [];
    for (const fn of fns) fn();
    return fns.length > 0;
  }

  /** Runs the timer that is due first until then. Returns whether there was one. */
  #runTimer(untilMs: number): boolean {
    let next: Timer | undefined;
    for (const timer of this.#timers) {
      if (timer.dueMs <= untilMs && (next === undefined || timer.dueMs < next.dueMs)) next = timer;
    }
    if (next === undefined) return false;
    this.#elapsedMs = Math.max(this.#elapsedMs, next.dueMs);
    if (next.intervalMs === undefined) this.#timers.delete(next);
    else next.dueMs += next.intervalMs;
    next.fn();
    return true;
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
