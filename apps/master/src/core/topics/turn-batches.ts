import { BatchNode } from './batch-node.ts';

/** The empty batch that the batches of all subscribers begin with in one turn of the event loop. */
export class TurnBatches {
  #empty = BatchNode.empty();

  get empty(): BatchNode {
    return this.#empty;
  }

  /** Starts the batches of the next turn, and releases the records of this one. */
  renew(): void {
    this.#empty = BatchNode.empty();
  }
}
