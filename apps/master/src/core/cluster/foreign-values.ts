import type { Clock } from '@ubii/timing';
import { LOST_AFTER_MS } from '../clients/liveness.ts';
import { endForeign } from '../topics/foreign-records.ts';
import type { TopicTable } from '../topics/topic-table.ts';

/** Dependencies of foreign values. */
export interface ForeignValuesContext {
  readonly clock: Clock;
  readonly topics: TopicTable;
}

/** Ends the values of other masters that stay away, and those that have no subscribers here. */
export class ForeignValues {
  readonly #context: ForeignValuesContext;
  /** Masters whose values end when they stay away, with that time; monotonic milliseconds. */
  readonly #absent = new Map<string, number>();

  constructor(context: ForeignValuesContext) {
    this.#context = context;
  }

  handleJoined(masterId: string): void {
    this.#absent.delete(masterId);
  }

  handleLost(masterId: string): void {
    this.#absent.set(masterId, this.#context.clock.monotonicMs() + LOST_AFTER_MS);
  }

  /** Ends the values of masters that stayed away. To be called about twice a second. [CU-14] */
  sweep(): void {
    const { clock, topics } = this.#context;
    const nowMs = clock.monotonicMs();
    for (const [id, endMs] of this.#absent) {
      if (nowMs < endMs) continue;
      this.#absent.delete(id);
      for (const entry of topics.values()) endForeign(topics, entry, id);
    }
  }

  /** Deletes values without subscribers here: they would not be kept up to date. [CU-13] */
  endUnwanted(): void {
    const { topics } = this.#context;
    for (const entry of topics.values()) {
      if (entry.originId === undefined) continue;
      const { ownDirect, ownSampled } = topics.targetsOf(entry);
      if (ownDirect + ownSampled === 0) topics.dropForeign(entry);
    }
  }
}
