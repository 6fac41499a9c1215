import { decodeRecord, type TopicRecord } from '@ubii/proto';

/** A value on an output topic. */
export interface Output {
  /** Moment of the recording, nanoseconds since the Unix epoch. */
  readonly timeNs: bigint;
  /** Undefined for a record without value or with bytes that cannot be decoded. */
  readonly record: TopicRecord | undefined;
}

/** Outputs of one topic with those that follow, and the last ones before. */
export class OutputQueue {
  readonly #outputs: AsyncIterator<Output> | Iterator<Output>;
  readonly #ahead: Output[] = [];
  readonly #past: Output[] = [];
  #isDone = false;

  /** @param outputs in the order of time */
  constructor(outputs: AsyncIterable<Output> | Iterable<Output>) {
    this.#outputs =
      Symbol.asyncIterator in outputs
        ? outputs[Symbol.asyncIterator]()
        : outputs[Symbol.iterator]();
  }

  /** The last outputs that were skipped. */
  get past(): readonly Output[] {
    return this.#past;
  }

  /** Returns the next outputs, at most `count`. */
  async peek(count: number): Promise<readonly Output[]> {
    while (this.#ahead.length < count && !this.#isDone) {
      const next = await this.#outputs.next();
      if (next.done === true) this.#isDone = true;
      else this.#ahead.push(next.value);
    }
    return this.#ahead;
  }

  /** @param kept how many of the last ones stay in `past` */
  skip(count: number, kept: number): void {
    this.#past.push(...this.#ahead.splice(0, count));
    this.#past.splice(0, this.#past.length - kept);
  }
}

/** The value of encoded bytes; undefined for a record without value, and for bytes that cannot be decoded. */
export function decodedOutput(bytes: Uint8Array): TopicRecord | undefined {
  try {
    const record = decodeRecord(bytes);
    return record.format === undefined ? undefined : record;
  } catch {
    return undefined;
  }
}
