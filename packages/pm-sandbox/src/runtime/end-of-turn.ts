import type { Clock } from '../ports/clock.ts';

/** Something that is looked at once, at the end of the turn of the event loop. */
export interface TurnTask {
  handleEndOfTurn(): void;
}

/** Gathers what the end of the turn is awaited for: one call of the clock for all instances. [PM-23] */
export class EndOfTurn {
  readonly #clock: Clock;
  #tasks: TurnTask[] = [];

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** The task's owner sees to it that it is added once a turn. */
  add(task: TurnTask): void {
    if (this.#tasks.push(task) === 1) this.#clock.atEndOfTurn(this.#handle);
  }

  readonly #handle = (): void => {
    const tasks = this.#tasks;
    this.#tasks = [];
    for (let i = 0; i < tasks.length; i++) tasks[i]!.handleEndOfTurn();
  };
}
