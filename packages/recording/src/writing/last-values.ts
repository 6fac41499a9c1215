import { McapRecordBuilder } from '@mcap/core';
import type { Attachment, Message } from '@mcap/core';
import { SNAPSHOT_NAME, SNAPSHOT_TYPE } from '../mcap/snapshot-attachment.ts';

/** Larger records are found in their chunks. */
const MAX_RECORD_BYTES = 16 * 1024;
/** A file has a snapshot for each so many bytes: that much is read, at most, to seek. */
const BYTES_BETWEEN = 4 * 1024 * 1024;
/** Snapshots take up to a 16th of a file. */
const SHARE = 16;

type LastValue = { -readonly [K in keyof Message]: Message[K] };

/**
 * The last value of each channel, written as a snapshot now and then: seeking reads one and the few chunks that follow it,
 * and not the chunk that each value was written in. A snapshot is a row of MCAP message records.
 */
export class LastValues {
  readonly #latest = new Map<number, LastValue>();
  #endNs = 0n;
  #nextAt = BigInt(BYTES_BETWEEN);

  /** Remembers a copy of a message, unless a later one of its channel is known. */
  add(message: Message): void {
    if (message.logTime > this.#endNs) this.#endNs = message.logTime;
    const known = this.#latest.get(message.channelId);
    if (known !== undefined && known.logTime > message.logTime) return;
    if (message.data.length > MAX_RECORD_BYTES) {
      this.#latest.delete(message.channelId);
    } else if (known?.data.length === message.data.length) {
      known.data.set(message.data);
      known.logTime = message.logTime;
      known.publishTime = message.publishTime;
      known.sequence = message.sequence;
    } else this.#latest.set(message.channelId, { ...message, data: message.data.slice() });
  }

  /** A snapshot, when one is due. @param position bytes of the file so far */
  snapshotAt(position: bigint): Attachment | undefined {
    if (position < this.#nextAt) return undefined;
    const builder = new McapRecordBuilder();
    for (const message of this.#latest.values()) builder.writeMessage(message);
    const data = builder.buffer;
    this.#nextAt = position + BigInt(Math.max(BYTES_BETWEEN, SHARE * data.length));
    const times = { logTime: this.#endNs, createTime: this.#endNs };
    return { name: SNAPSHOT_NAME, mediaType: SNAPSHOT_TYPE, ...times, data };
  }
}
