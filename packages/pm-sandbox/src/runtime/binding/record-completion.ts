import { DATA_FORMATS, encode, encodeRecord, timestampFromMs } from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';
import type { SandboxInput, SandboxValue } from '../../ports/sandbox.ts';

/** `TopicDataRecord.timestamp`: field 2, length-delimited. */
const TIMESTAMP_TAG = 0x12;
const NOTHING = new Uint8Array();
const PICTURES: ReadonlySet<number> = new Set([
  DATA_FORMATS.image2D.fieldNumber,
  DATA_FORMATS.image2DList.fieldNumber,
]);

/** Whether the value of a record is a picture, or several. */
export function isPicture(valueField: number): boolean {
  return PICTURES.has(valueField);
}

/**
 * Expiry of pictures that were computed from these inputs, as encoded fields: the longest of those that expire. [PM-37]
 */
export function expiryOf(inputs: readonly SandboxInput[]): Uint8Array {
  let longestMs = 0;
  for (const input of inputs) {
    const records = 'elements' in input ? input.elements : [input.record];
    for (const record of records) {
      if (record !== undefined)
        longestMs = Math.max(longestMs, readRecordHead(record.bytes).expiryMs);
    }
  }
  if (longestMs === 0) return NOTHING;
  return encode('ubii.topicData.TopicDataRecord', { extension: { expiryMs: longestMs } });
}

/**
 * Makes complete records of what modules put out, by putting encoded fields after the encoded value:
 * protobuf merges them, and of two topics the later one counts, so that a module cannot say another
 * topic or client than it publishes on and runs at. The value is not read. [PM-32]
 */
export class RecordCompletion {
  readonly #nodeId: string;
  #stampMs = Number.NaN;
  #stamp = new Uint8Array();

  /** @param nodeId the client id of all records */
  constructor(nodeId: string) {
    this.#nodeId = nodeId;
  }

  /** Encoded topic and client id; to be made once for each topic. */
  origin(topic: string): Uint8Array {
    return encodeRecord({ topic, clientId: this.#nodeId });
  }

  /**
   * The complete record, in memory of its own.
   *
   * @param nowMs epoch milliseconds, put in unless the module gave a timestamp
   * @param expiry of `expiryOf`
   */
  complete(
    value: SandboxValue,
    origin: Uint8Array,
    nowMs: number,
    expiry: Uint8Array = NOTHING,
  ): Uint8Array {
    const { bytes, hasTimestamp } = value;
    const stamp = hasTimestamp ? NOTHING : this.#stampOf(nowMs);
    const record = new Uint8Array(bytes.length + origin.length + stamp.length + expiry.length);
    record.set(bytes);
    record.set(origin, bytes.length);
    record.set(stamp, bytes.length + origin.length);
    record.set(expiry, bytes.length + origin.length + stamp.length);
    return record;
  }

  #stampOf(nowMs: number): Uint8Array {
    if (nowMs === this.#stampMs) return this.#stamp;
    const message = encode('ubii.topicData.Timestamp', timestampFromMs(nowMs));
    this.#stamp = new Uint8Array(2 + message.length);
    // Three numbers: far below the 128 bytes that a length of one byte can say.
    this.#stamp.set([TIMESTAMP_TAG, message.length]);
    this.#stamp.set(message, 2);
    this.#stampMs = nowMs;
    return this.#stamp;
  }
}
