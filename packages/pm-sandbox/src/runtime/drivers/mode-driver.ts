import type { Cancel, TurnTask } from '@ubii/timing';

/** Says when an instance runs. Made for one mode, started and stopped any number of times. */
export interface ModeDriver {
  start(): void;
  /** No run starts after this. */
  stop(): void;
  /** The run under way ended. */
  handleRunEnd(): void;
  /** An input was marked. */
  handleMark(): void;
  /** Runs that are due and cannot start yet: 0 or 1. */
  readonly waiting: number;
}

/** The instance, as seen by its driver. */
export interface RunHost {
  /** A run is under way. */
  readonly isBusy: boolean;
  /** Start of the newest run, monotonic milliseconds; undefined before the first. */
  readonly lastStartMs: number | undefined;
  monotonicMs(): number;
  after(delayMs: number, fn: () => void): Cancel;
  /** Once for each task and turn. */
  atEndOfTurn(task: TurnTask): void;
  /**
   * Starts a run. Only when none is under way.
   *
   * @param triggers names of the inputs that caused it [PM-12]
   */
  run(triggers?: readonly string[]): void;
  /**
   * A run was still under way when the next one was due. [PM-22]
   *
   * @param intervalMs between two runs
   */
  countOverrun(intervalMs: number): void;
}
