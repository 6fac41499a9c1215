/** Ends what `every` or `after` began. Calling it twice, or too late, does nothing. */
export type Cancel = () => void;

/** The only source of time, timers and turns of the event loop. */
export interface Clock {
  /** Milliseconds since the Unix epoch. May jump when the system's clock is set. */
  nowMs(): number;
  /** Milliseconds since an arbitrary moment, with fractions, never going backwards: for ages and durations. */
  monotonicMs(): number;
  /** Calls `fn` every `intervalMs` milliseconds, the first time after one interval. */
  every(intervalMs: number, fn: () => void): Cancel;
  /** Calls `fn` once, after `delayMs` milliseconds; 0 gives other work a turn first. */
  after(delayMs: number, fn: () => void): Cancel;
  /** Calls `fn` once, at the end of this turn of the event loop. Calls run in the order they were asked for. */
  atEndOfTurn(fn: () => void): void;
}

/** A clock that tells the time of day to others [TS-2]. */
export interface PreciseClock extends Clock {
  /** The same time as `nowMs`, with fractions. Costs more. */
  preciseMs(): number;
}
