import { encode, encodeRecord, timestampFromMs } from '@ubii/proto';
import type { SandboxValue } from '../../ports/sandbox.ts';

/** `TopicDataRecord.timestamp`: field 2, length-delimited. */
const TIMESTAMP_TAG = 0x12;

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
   */
  complete(value: SandboxValue, origin: Uint8Array, nowMs: number): Uint8Array {
    const { bytes, hasTimestamp } = value;
    const stamp = hasTimestamp ? undefined : this.#stampOf(nowMs);
    const record = new Uint8Array(bytes.length + origin.length + (stamp?.length ?? 0));
    record.set(bytes);
    record.set(origin, bytes.length);
    if (stamp !== undefined) record.set(stamp, bytes.length + origin.length);
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
