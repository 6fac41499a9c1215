/**
 * The records one async iterator has not taken yet. Holds `capacity` at most: over that the oldest
 * is dropped, because in a live system the newest matters.
 */
export class RecordBuffer<T> implements AsyncIterator<T, undefined> {
  readonly #capacity: number;
  readonly #handleReturn: () => void;
  #records: T[] = [];
  /** Index of the oldest record; those before it are taken. Keeps taking cheap for long buffers. */
  #first = 0;
  #waiting: {
    resolve: (result: IteratorResult<T, undefined>) => void;
    reject: (e: unknown) => void;
  }[] = [];
  #end: { readonly error: Error | undefined } | undefined;
  #dropped = 0;

  /** @param handleReturn called when the consumer leaves its loop */
  constructor(capacity: number, handleReturn: () => void) {
    this.#capacity = capacity;
    this.#handleReturn = handleReturn;
  }

  get dropped(): number {
    return this.#dropped;
  }

  push(record: T): void {
    if (this.#end !== undefined) return;
    const waiting = this.#waiting.shift();
    if (waiting !== undefined) {
      waiting.resolve({ done: false, value: record });
      return;
    }
    this.#records.push(record);
    if (this.#records.length - this.#first > this.#capacity) {
      this.#dropped += 1;
      this.#take();
    }
  }

  /** No more records: what is held is still given, then the loop ends, or throws the error. */
  end(error: Error | undefined): void {
    if (this.#end !== undefined) return;
    this.#end = { error };
    const waiting = this.#waiting;
    this.#waiting = [];
    for (const { resolve, reject } of waiting) {
      if (error === undefined) resolve({ done: true, value: undefined });
      else reject(error);
    }
  }

  /** Takes all that is held. */
  drain(): T[] {
    const records = this.#records.slice(this.#first);
    this.#records = [];
    this.#first = 0;
    return records;
  }

  next(): Promise<IteratorResult<T, undefined>> {
    if (this.#first < this.#records.length) {
      return Promise.resolve({ done: false, value: this.#take() });
    }
    if (this.#end === undefined) {
      return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject }));
    }
    const { error } = this.#end;
    if (error === undefined) return Promise.resolve({ done: true, value: undefined });
    this.#end = { error: undefined }; // an iterator throws once
    return Promise.reject(error);
  }

  return(): Promise<IteratorResult<T, undefined>> {
    this.#records = [];
    this.#first = 0;
    this.end(undefined);
    this.#handleReturn();
    return Promise.resolve({ done: true, value: undefined });
  }

  #take(): T {
    const record = this.#records[this.#first]!;
    this.#first += 1;
    if (this.#first > 1024 && this.#first * 2 > this.#records.length) {
      this.#records = this.#records.slice(this.#first);
      this.#first = 0;
    }
    return record;
  }
}
