import type { Clock } from '../ports/clock.ts';
import { BatchNode } from './batch-node.ts';

/** What has something to send when the turn ends. */
export interface Flushable {
  flush(): void;
}

/** Collects who was given records in this turn of the event loop, and flushes them when it ends [TD-30]. */
export class EndOfTurn {
  readonly #clock: Clock;
  #touched: Flushable[] = [];
  #root = BatchNode.empty();

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** The empty batch that everybody's batch of this turn begins with. */
  get emptyBatch(): BatchNode {
    return this.#root;
  }

  /** Asks for `flushable.flush()` at the end of this turn; once a turn is enough. */
  touch(flushable: Flushable): void {
    if (this.#touched.length === 0) this.#clock.atEndOfTurn(this.#flush);
    this.#touched.push(flushable);
  }

  readonly #flush = (): void => {
    const flushables = this.#touched;
    this.#touched = [];
    // A new root lets go of the records of this turn.
    this.#root = BatchNode.empty();
    for (let i = 0; i < flushables.length; i++) flushables[i]!.flush();
  };
}
