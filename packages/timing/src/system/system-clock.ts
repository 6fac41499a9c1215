import type { Cancel, Clock } from '../clock.ts';

/** Settings that differ between programs. */
export interface SystemClockOptions {
  /**
   * Calls a function at the end of this turn of the event loop. Default: as a microtask, for a frame, a
   * message and a timer each are a turn of their own in a page or a worker.
   */
  readonly endTurn?: (fn: () => void) => void;
  /** Handles what a callback throws. Default: it is an uncaught error of the program. */
  readonly handleError?: (error: unknown) => void;
}

/** The clock, the timers and the event loop of this program. */
export class SystemClock implements Clock {
  readonly #endTurn: (fn: () => void) => void;
  readonly #call: (fn: () => void) => void;

  constructor({ endTurn, handleError }: SystemClockOptions = {}) {
    this.#endTurn = endTurn ?? ((fn) => queueMicrotask(fn));
    this.#call = handleError === undefined ? call : guarded(handleError);
  }

  nowMs(): number {
    return Date.now();
  }

  monotonicMs(): number {
    return performance.now();
  }

  every(intervalMs: number, fn: () => void): Cancel {
    const timer = setInterval(this.#call, intervalMs, fn);
    return () => clearInterval(timer);
  }

  after(delayMs: number, fn: () => void): Cancel {
    const timer = setTimeout(this.#call, delayMs, fn);
    return () => clearTimeout(timer);
  }

  atEndOfTurn(fn: () => void): void {
    this.#endTurn(() => this.#call(fn));
  }
}

/** The clock of a program that lets errors of callbacks be uncaught, with microtasks at the end of a turn. */
export const systemClock: Clock = new SystemClock();

function call(fn: () => void): void {
  fn();
}

function guarded(handleError: (error: unknown) => void): (fn: () => void) => void {
  return (fn) => {
    try {
      fn();
    } catch (error) {
      handleError(error);
    }
  };
}
