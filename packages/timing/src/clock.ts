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

/**
 * Waits for work, but not longer than `timeoutMs`. What happens to it later is ignored.
 *
 * @returns false when the time was over first
 * @throws what the work rejects with, if it does so in time
 */
export function within(
  clock: Pick<Clock, 'after'>,
  timeoutMs: number,
  work: Promise<unknown>,
): Promise<boolean> {
  return new Promise((resolve, reject) => {
    const cancel = clock.after(timeoutMs, () => resolve(false));
    work.then(
      () => {
        cancel();
        resolve(true);
      },
      (reason: unknown) => {
        cancel();
        reject(reason as Error);
      },
    );
  });
}

/** A task that runs once, at the end of the turn of the event loop. */
export interface TurnTask {
  handleEndOfTurn(): void;
}

/**
 * Collects the tasks of this turn of the event loop, and runs them when it ends: one call of the clock
 * for all of them [TD-30] [PM-23]. While only one reader has input, its turn ends when that has been
 * read: no other has anything to add, and waiting for the loop to come round would only add latency.
 */
export class EndOfTurn {
  readonly #clock: Pick<Clock, 'atEndOfTurn'>;
  readonly #onEnd: (() => void) | undefined;
  /** Source of the input that was read last. */
  #reader: object | undefined = undefined;
  /** Input is being read of the one reader that alone has some. */
  #isReadingAlone = false;
  #tasks: TurnTask[] = [];

  /** @param onEnd Called when a turn with tasks ends, before the first of them. */
  constructor(clock: Pick<Clock, 'atEndOfTurn'>, onEnd?: () => void) {
    this.#clock = clock;
    this.#onEnd = onEnd;
  }

  /** Runs `task` at the end of this turn, as often as it is added: its owner adds it once a turn. */
  add(task: TurnTask): void {
    if (this.#tasks.length === 0 && !this.#isReadingAlone) this.#clock.atEndOfTurn(this.#run);
    this.#tasks.push(task);
  }

  /** Input of `reader` is handled from now on, until `endRead`. */
  beginRead(reader: object): void {
    // Data that others queued in this turn leaves with it.
    this.#isReadingAlone = reader === this.#reader && this.#tasks.length === 0;
    this.#reader = reader;
  }

  /** The input that was at hand was handled. */
  endRead(): void {
    if (!this.#isReadingAlone) return;
    this.#isReadingAlone = false;
    if (this.#tasks.length > 0) this.#run();
  }

  readonly #run = (): void => {
    const tasks = this.#tasks;
    this.#tasks = [];
    this.#onEnd?.();
    for (let i = 0; i < tasks.length; i++) tasks[i]!.handleEndOfTurn();
  };
}
