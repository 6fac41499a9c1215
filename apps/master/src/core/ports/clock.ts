/** Ends what `every` or `after` began. Calling it twice, or too late, does nothing. */
export type Cancel = () => void;

/** Time and the event loop, as the core sees them. */
export interface Clock {
  /** Milliseconds since the Unix epoch. May jump when the system's clock is set. */
  nowMs(): number;
  /** The same time with fractions, to be told to clients [TS-2]. Costs more. */
  preciseMs(): number;
  /** Milliseconds since an arbitrary moment, never going backwards: for ages and durations. */
  monotonicMs(): number;
  /** Calls `fn` every `intervalMs` milliseconds, the first time after one interval. */
  every(intervalMs: number, fn: () => void): Cancel;
  /** Calls `fn` once, after `delayMs` milliseconds; 0 gives other work a turn first. */
  after(delayMs: number, fn: () => void): Cancel;
  /**
   * Calls `fn` once, at the end of this turn of the event loop: after the input that is at hand was
   * handled, before the process waits for more. Calls run in the order they were asked for.
   */
  atEndOfTurn(fn: () => void): void;
}
