import type { Cancel, Clock } from '../core/ports/clock.ts';

interface Timer {
  dueMs: number;
  readonly everyMs: number | undefined;
  readonly fn: () => void;
}

/** A clock that moves only when told to. */
export class FakeClock implements Clock {
  #elapsedMs = 0;
  readonly #timers = new Set<Timer>();
  #epochMs: number;

  /** @param epochMs what `nowMs` starts from. @default 1 700 000 000 000 */
  constructor(epochMs = 1_700_000_000_000) {
    this.#epochMs = epochMs;
  }

  nowMs(): number {
    return this.#epochMs + this.#elapsedMs;
  }

  monotonicMs(): number {
    return this.#elapsedMs;
  }

  /** Sets the time of day: forwards it is also what a machine sees that slept so long. */
  setWall(byMs: number): void {
    this.#epochMs += byMs;
  }

  /** Timers stand still for so long, then what fell due is called once, too late: a page that was frozen. */
  async sleep(forMs: number): Promise<void> {
    this.#elapsedMs += forMs;
    for (const timer of this.#timers) {
      if (timer.everyMs !== undefined) timer.dueMs = Math.max(timer.dueMs, this.#elapsedMs);
    }
    await this.advance(0);
  }

  after(delayMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#elapsedMs + delayMs, everyMs: undefined, fn });
  }

  every(intervalMs: number, fn: () => void): Cancel {
    return this.#add({ dueMs: this.#elapsedMs + intervalMs, everyMs: intervalMs, fn });
  }

  /** Timers that wait: 0 when everything was cancelled. */
  get pendingTimers(): number {
    return this.#timers.size;
  }

  /** Moves on, calls what falls due in its order, and lets promises settle after each. */
  async advance(byMs: number): Promise<void> {
    const endMs = this.#elapsedMs + byMs;
    await settle();
    for (let timer = this.#nextDue(endMs); timer !== undefined; timer = this.#nextDue(endMs)) {
      this.#elapsedMs = Math.max(this.#elapsedMs, timer.dueMs);
      if (timer.everyMs === undefined) this.#timers.delete(timer);
      else timer.dueMs += timer.everyMs;
      timer.fn();
      await settle();
    }
    this.#elapsedMs = endMs;
  }

  #add(timer: Timer): Cancel {
    this.#timers.add(timer);
    return () => this.#timers.delete(timer);
  }

  #nextDue(endMs: number): Timer | undefined {
    let next: Timer | undefined;
    for (const timer of this.#timers) {
      if (timer.dueMs <= endMs && (next === undefined || timer.dueMs < next.dueMs)) next = timer;
    }
    return next;
  }
}

/** Resolves when every promise chain under way has come to rest or waits for something outside. */
export function settle(): Promise<void> {
  return new Promise((resolve) => setImmediate(resolve));
}
