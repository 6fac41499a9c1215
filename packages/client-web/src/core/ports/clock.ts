/** Undoes what a timer was set up to do; calling it again does nothing. */
export type Cancel = () => void;

/** The client's only source of time. A clock of the master's core fits as well. */
export interface Clock {
  /** Milliseconds since the Unix epoch; may jump when the system's clock is set. */
  nowMs(): number;
  /** Milliseconds since an arbitrary moment; never goes back. */
  monotonicMs(): number;
  /** Calls `fn` once, `delayMs` from now at the earliest. */
  after(delayMs: number, fn: () => void): Cancel;
  /** Calls `fn` every `intervalMs` until cancelled. */
  every(intervalMs: number, fn: () => void): Cancel;
}
