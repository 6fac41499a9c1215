import type { Clock } from './clock.ts';

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
