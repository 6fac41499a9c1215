/** What one client received of one topic, whose records have numbers that grow by one. */
export class Reception {
  readonly topic: string;
  #last: number | undefined;
  #missing = 0;
  #again = 0;
  #disorder = 0;
  #received = 0;

  constructor(topic: string) {
    this.topic = topic;
  }

  /** The greatest number so far; undefined before the first record. */
  get last(): number | undefined {
    return this.#last;
  }

  handle(number: number): void {
    this.#received += 1;
    const last = this.#last ?? number - 1;
    if (number === last) this.#again += 1;
    else if (number < last) this.#disorder += 1;
    else this.#missing += number - last - 1;
    this.#last = Math.max(last, number);
  }

  /** Gives what was counted since the last call. */
  take(): ReceptionCounts {
    const counts = {
      received: this.#received,
      missing: this.#missing,
      again: this.#again,
      disorder: this.#disorder,
    };
    this.#received = this.#missing = this.#again = this.#disorder = 0;
    return counts;
  }
}

/** Counts of records. */
export interface ReceptionCounts {
  readonly received: number;
  /** Numbers that were left out. */
  readonly missing: number;
  /** Records with the number of the one before. */
  readonly again: number;
  /** Records with a lower number than one before. */
  readonly disorder: number;
}

/** Counts of all clients that were at one master and were in the same case. */
export interface ReceptionRow extends ReceptionCounts {
  readonly topic: string;
  /** URL of the master that they were at when the phase of the run began. */
  readonly home: string;
  /** Whether they lost a connection, or changed to another master, since then. */
  readonly moved: boolean;
}

/** A topic and its publisher. */
export interface PublisherRow {
  readonly topic: string;
  readonly home: string;
  readonly moved: boolean;
  /** Number of the last record. */
  readonly last: number;
}
