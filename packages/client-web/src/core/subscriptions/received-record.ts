import { DATA_FORMATS, decodeRecord, encodeRecord } from '@ubii/proto';
import type { EmptyRecord, RecordInit, TopicRecord } from '@ubii/proto';
import { TextCache, readRecordHead } from '@ubii/proto/wire';
import type { EncodedRecord } from './encoded-record.ts';

/** Topics and ids of publishers come with every record. */
const texts = new TextCache();

/**
 * A received record, decoded and encoded. Each form is created once, on first use,
 * for all receivers.
 */
export class ReceivedRecord {
  readonly topic: string;
  /** True when the buffer contains only this record and is large enough to be transferred. */
  readonly isTransferable: boolean;
  #decoded: TopicRecord | EmptyRecord | undefined;
  #bytes: Uint8Array | undefined;
  #encoded: EncodedRecord | undefined;
  readonly #valueField: number;

  private constructor(
    topic: string,
    valueField: number,
    isTransferable: boolean,
    content: { decoded?: TopicRecord | EmptyRecord; bytes?: Uint8Array },
  ) {
    this.topic = topic;
    this.isTransferable = isTransferable;
    this.#valueField = valueField;
    this.#decoded = content.decoded;
    this.#bytes = content.bytes;
  }

  static fromDecoded(decoded: TopicRecord | EmptyRecord): ReceivedRecord {
    const valueField = decoded.format === undefined ? 0 : DATA_FORMATS[decoded.format].fieldNumber;
    return new ReceivedRecord(decoded.topic, valueField, false, { decoded });
  }

  /** @param bytes an encoded record whose structure was checked */
  static fromEncoded(
    topic: string,
    bytes: Uint8Array,
    valueField: number,
    isTransferable: boolean,
  ): ReceivedRecord {
    return new ReceivedRecord(topic, valueField, isTransferable, { bytes });
  }

  /** False for a record that only says that its topic has no value. [TD-13] */
  get hasValue(): boolean {
    return this.#valueField !== 0;
  }

  /** Only when there is a value. */
  get decoded(): TopicRecord {
    this.#decoded ??= decodeRecord(this.#bytes!);
    return this.#decoded as TopicRecord;
  }

  get encoded(): EncodedRecord {
    this.#encoded ??= this.#encode(false);
    return this.#encoded;
  }

  /** Gives the buffer away; nothing else may be asked of this record afterwards. */
  handOver(): EncodedRecord {
    return this.#encode(true);
  }

  #encode(isOwned: boolean): EncodedRecord {
    this.#bytes ??= encodeRecord(this.#decoded as RecordInit);
    return {
      topic: this.topic,
      bytes: this.#bytes,
      valueField: this.#valueField,
      publisherId: readRecordHead(this.#bytes, texts).clientId,
      isOwned,
    };
  }
}
