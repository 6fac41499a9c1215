/** Property of records that a window needs. */
export interface WindowRecord {
  readonly topic: string;
  /** Publisher's clock, epoch milliseconds. */
  readonly timestampMs?: number | undefined;
}

/** Snapshot of the records of live topics. */
export interface RecordView<R> {
  /** The record received last. */
  readonly newest: R | undefined;
  /** Last records of each topic, oldest first. */
  readonly records: readonly R[];
  /** Newest record of each topic. */
  readonly byTopic: ReadonlyMap<string, R>;
  /** Number of received records. */
  readonly received: number;
  /**
   * Number of received records that were replaced before any view showed them. Records dropped by a rate limit are not
   * included.
   */
  readonly dropped: number;
}

/** Most topics of a glob, against publishers with many topics. */
export const MAX_TOPICS = 2000;

interface Kept<R> {
  readonly pattern: string;
  readonly records: R[];
  /** Number of records that no view has shown yet. */
  fresh: number;
  /** Sequence number over the records of all topics. */
  number: number;
  /** True when the master may send the newest record again. */
  mayRepeat: boolean;
}

/** Last records of each topic, with the numbers of received and dropped ones. */
export class RecordWindow<R extends WindowRecord> {
  readonly #keep: number;
  readonly #kept = new Map<string, Kept<R>>();
  #received = 0;
  #dropped = 0;

  /** @param keep number of records per topic */
  constructor(keep: number) {
    this.#keep = keep;
  }

  /**
   * @param pattern key of its subscription
   * @returns false for a repeated record
   */
  add(record: R, pattern: string): boolean {
    const kept = this.#kept.get(record.topic);
    if (kept?.mayRepeat === true) {
      kept.mayRepeat = false;
      const knownMs = kept.records.at(-1)?.timestampMs;
      if (knownMs !== undefined && knownMs === record.timestampMs) return false;
    }
    this.#received += 1;
    if (kept !== undefined) this.#push(kept, record);
    else if (this.#kept.size >= MAX_TOPICS) this.#dropped += 1;
    else {
      const first = { records: [record], fresh: 1, number: this.#received, mayRepeat: false };
      this.#kept.set(record.topic, { pattern, ...first });
    }
    return true;
  }

  /** The master sends newest records again: after a reconnect all, after a subscription those of its pattern. */
  expectRepeats(pattern?: string): void {
    for (const kept of this.#kept.values()) {
      kept.mayRepeat ||= pattern === undefined || kept.pattern === pattern;
    }
  }

  /** Drops the records of a pattern. */
  forget(pattern: string): void {
    for (const [topic, kept] of this.#kept) {
      if (kept.pattern === pattern) this.#kept.delete(topic);
    }
  }

  /** Returns a snapshot; its records then count as shown. */
  take(): RecordView<R> {
    const byTopic = new Map<string, R>();
    const records: R[] = [];
    let newest: Kept<R> | undefined;
    for (const [topic, kept] of this.#kept) {
      kept.fresh = 0;
      byTopic.set(topic, kept.records.at(-1)!);
      records.push(...kept.records);
      if (newest === undefined || kept.number > newest.number) newest = kept;
    }
    const counts = { received: this.#received, dropped: this.#dropped };
    return { newest: newest?.records.at(-1), records, byTopic, ...counts };
  }

  #push(kept: Kept<R>, record: R): void {
    kept.number = this.#received;
    kept.records.push(record);
    kept.fresh += 1;
    if (kept.records.length <= this.#keep) return;
    kept.records.shift();
    if (kept.fresh <= this.#keep) return;
    kept.fresh = this.#keep;
    this.#dropped += 1;
  }
}
