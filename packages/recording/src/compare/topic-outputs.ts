import { decodeRecord, type TopicRecord } from '@ubii/proto';
import type { RecordedRecord } from '../records/recorded-record.ts';

/** A value on an output topic. */
export interface Output {
  /** Moment of the recording, nanoseconds since the Unix epoch. */
  readonly timeNs: bigint;
  /** Undefined for a record without value or with bytes that cannot be decoded. */
  readonly record: TopicRecord | undefined;
}

/** Outputs of one topic with those that follow. */
export class TopicOutputs {
  readonly #records: AsyncIterator<RecordedRecord>;
  readonly #toRecorded: (timeNs: bigint) => bigint;
  readonly #ahead: Output[] = [];
  #isDone = false;

  /** @param toRecorded gives the moment of the recording of a log time */
  constructor(
    records: AsyncIterable<RecordedRecord>,
    toRecorded: (timeNs: bigint) => bigint = (timeNs) => timeNs,
  ) {
    this.#records = records[Symbol.asyncIterator]();
    this.#toRecorded = toRecorded;
  }

  /** Returns the next outputs, at most `count`. */
  async peek(count: number): Promise<readonly Output[]> {
    while (this.#ahead.length < count && !this.#isDone) {
      const next = await this.#records.next();
      if (next.done === true) this.#isDone = true;
      else this.#ahead.push(this.#toOutput(next.value));
    }
    return this.#ahead;
  }

  skip(count: number): void {
    this.#ahead.splice(0, count);
  }

  #toOutput({ logTimeNs, record }: RecordedRecord): Output {
    return { timeNs: this.#toRecorded(logTimeNs), record: decoded(record) };
  }
}

function decoded(bytes: Uint8Array): TopicRecord | undefined {
  try {
    const record = decodeRecord(bytes);
    return record.format === undefined ? undefined : record;
  } catch {
    return undefined;
  }
}
