import type { Clock } from '../ports/clock.ts';
import { BatchNode } from './batch-node.ts';

/** What has something to send when the turn ends. */
export interface Flushable {
  flush(): void;
}

/**
 * Collects who was given records in this turn of the event loop, and flushes them when it ends [TD-30].
 * While only one client sends, its turn ends when its input has been read: no other client has
 * anything to add, and waiting for the loop to come round would only add to everybody's latency.
 */
export class EndOfTurn {
  readonly #clock: Clock;
  /** Whose input was read last. */
  #reader: object | undefined = undefined;
  /** Input is being read of the one client that alone sends. */
  #isReadingAlone = false;
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
    if (this.#touched.length === 0 && !this.#isReadingAlone) this.#clock.atEndOfTurn(this.#flush);
    this.#touched.push(flushable);
  }

  /** Input of `reader` is handled from now on, until `endRead`. */
  beginRead(reader: object): void {
    // What others have left in this turn leaves with it.
    this.#isReadingAlone = reader === this.#reader && this.#touched.length === 0;
    this.#reader = reader;
  }

  /** The input that was at hand was handled. */
  endRead(): void {
    if (!this.#isReadingAlone) return;
    this.#isReadingAlone = false;
    if (this.#touched.length > 0) this.#flush();
  }

  readonly #flush = (): void => {
    const flushables = this.#touched;
    this.#touched = [];
    // A new root lets go of the records of this turn.
    this.#root = BatchNode.empty();
    for (let i = 0; i < flushables.length; i++) flushables[i]!.flush();
  };
}
