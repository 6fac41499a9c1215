/** What a window needs to know of a record. */
export interface WindowRecord {
  readonly topic: string;
  /** By the publisher's clock, milliseconds since the Unix epoch. */
  readonly timestampMs?: number | undefined;
}

/** What is kept of live topics at one moment. */
export interface RecordView<R> {
  /** The record that came last. */
  readonly newest: R | undefined;
  /** The last records of each topic, oldest first. */
  readonly records: readonly R[];
  /** The newest record of each topic. */
  readonly byTopic: ReadonlyMap<string, R>;
  /** Records that came. */
  readonly received: number;
  /** Of these, the ones that no view had: newer ones replaced them first. The rate limit's are not among them. */
  readonly dropped: number;
}

/** Bounds what a glob keeps against a publisher of many topics. */
export const MAX_TOPICS = 2000;

interface Kept<R> {
  readonly pattern: string;
  readonly records: R[];
  /** How many of them no view had yet. */
  fresh: number;
  /** Counts up with the records of all topics. */
  number: number;
  /** The master may send the newest record again. */
  mayRepeat: boolean;
}

/** The last records of each topic, and how many came and went unseen. */
export class RecordWindow<R extends WindowRecord> {
  readonly #keep: number;
  readonly #kept = new Map<string, Kept<R>>();
  #received = 0;
  #dropped = 0;

  /** @param keep records kept of each topic */
  constructor(keep: number) {
    this.#keep = keep;
  }

  /**
   * @param pattern what it was subscribed to by
   * @returns false for a record that is known from before
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

  /** The master sends the newest records again, after a reconnect all, after a subscription those of its pattern. */
  expectRepeats(pattern?: string): void {
    for (const kept of this.#kept.values()) {
      kept.mayRepeat ||= pattern === undefined || kept.pattern === pattern;
    }
  }

  /** Forgets the records of a pattern. */
  forget(pattern: string): void {
    for (const [topic, kept] of this.#kept) {
      if (kept.pattern === pattern) this.#kept.delete(topic);
    }
  }

  /** What there is to draw; all of it counts as drawn then. */
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
