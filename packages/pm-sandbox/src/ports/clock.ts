/** Ends what `every` or `after` began. Calling it twice, or too late, does nothing. */
export type Cancel = () => void;

/** Time and the event loop, as the runtime sees them. */
export interface Clock {
  /** Milliseconds since the Unix epoch, by the clock of the master [PM-15]. May jump. */
  nowMs(): number;
  /** Milliseconds since an arbitrary moment, never going backwards, with fractions. */
  monotonicMs(): number;
  /** Calls `fn` every `intervalMs` milliseconds, the first time after one interval. */
  every(intervalMs: number, fn: () => void): Cancel;
  /** Calls `fn` once, after `delayMs` milliseconds; 0 gives other work a turn first. */
  after(delayMs: number, fn: () => void): Cancel;
  /** Calls `fn` once, at the end of this turn of the event loop, in the order of the calls. */
  atEndOfTurn(fn: () => void): void;
}
