import { readRecordHead } from '@ubii/proto/wire';
import type { Cancel, Clock } from '@ubii/timing';
import type { TopicEntry } from './topic-entry.ts';
import type { TopicTable } from './topic-table.ts';

/** Interval of checks for expired values, milliseconds. [TD-47] */
export const EXPIRY_SWEEP_MS = 250;

/** Dependencies of expiring values. */
export interface ExpiringValuesContext {
  readonly clock: Clock;
  readonly topics: TopicTable;
}

/**
 * Deletes the values whose records say how long they stand, such as pictures of cameras [TD-47]. Publishing
 * has no part in it: what a record says is read here, once, and only if no newer one came for a whole sweep.
 */
export class ExpiringValues {
  readonly #context: ExpiringValuesContext;
  readonly #cancel: Cancel;

  constructor(context: ExpiringValuesContext) {
    this.#context = context;
    this.#cancel = context.clock.every(EXPIRY_SWEEP_MS, () => this.#sweep());
  }

  close(): void {
    this.#cancel();
  }

  #sweep(): void {
    const nowMs = this.#context.clock.monotonicMs();
    // A topic may be forgotten on the way, which a Map takes well.
    for (const entry of this.#context.topics.values()) {
      if (entry.sequence !== entry.seenSequence) {
        entry.seenSequence = entry.sequence;
        entry.expiresMs = undefined;
      } else if (entry.record !== undefined) {
        entry.expiresMs ??= this.#expiresMs(entry, entry.record, nowMs);
        if (nowMs >= entry.expiresMs) this.#delete(entry);
      }
    }
  }

  #expiresMs(entry: TopicEntry, record: Uint8Array, nowMs: number): number {
    const { expiryMs } = readRecordHead(record);
    if (expiryMs <= 0) return Number.POSITIVE_INFINITY;
    // It came within the last two sweeps; what the clock of the system says otherwise is a clock that was set.
    const ageMs = this.#context.clock.nowMs() - entry.publishedMs;
    return nowMs - Math.min(Math.max(ageMs, EXPIRY_SWEEP_MS), 2 * EXPIRY_SWEEP_MS) + expiryMs;
  }

  #delete(entry: TopicEntry): void {
    const { topics } = this.#context;
    const { direct, sampled } = topics.targetsOf(entry);
    for (const receiver of direct) receiver.withdraw(entry);
    for (const sample of sampled) sample.sampler.withdraw(sample);
    topics.deleteValue(entry);
  }
}
