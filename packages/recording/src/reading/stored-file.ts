import type { AttachmentIndex, ChunkIndex } from '@mcap/core';
import { messagesIn, type StoredMessage } from '../mcap/chunk-content.ts';
import type { FileIndex } from '../mcap/file-index.ts';
import { SNAPSHOT_NAME } from '../mcap/snapshot-attachment.ts';
import { unpackChunk } from '../mcap/unpack-chunk.ts';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { ChunkMessages } from './chunk-messages.ts';
import { LruCache } from './lru-cache.ts';

/** Decompressed chunks that are kept: those between two snapshots, and some more. */
const CACHE_BYTES = 48 * 1024 * 1024;
const RECORD_HEAD_BYTES = 9;
/** `logTime` and `createTime` of an attachment record. */
const ATTACHMENT_TIMES_BYTES = 16;
const CRC_BYTES = 4;

/** A snapshot of last values. */
export interface Snapshot {
  /** Where it is in the file: chunks before hold nothing newer than it. */
  readonly offset: bigint;
  readonly messages: ReadonlyMap<number, StoredMessage>;
}

/** A file with its index: loads chunks and snapshots, and keeps those that were used last. */
export class StoredFile {
  readonly index: FileIndex;
  readonly #source: RecordingSource;
  readonly #chunks = new LruCache<ChunkMessages>(CACHE_BYTES);
  readonly #snapshots: readonly AttachmentIndex[];
  readonly #openSnapshots = new LruCache<Snapshot>(CACHE_BYTES / 4);

  constructor(source: RecordingSource, index: FileIndex) {
    this.#source = source;
    this.index = index;
    this.#snapshots = index.attachments.filter(({ name }) => name === SNAPSHOT_NAME);
  }

  /** The messages of a chunk. @throws RecordingError when it is broken */
  messagesOf(chunk: ChunkIndex): Promise<ChunkMessages> {
    const { chunkStartOffset, chunkLength, uncompressedSize } = chunk;
    return this.#chunks.get(chunkStartOffset, Number(uncompressedSize), async () => {
      const record = await this.#source.read(chunkStartOffset, chunkLength);
      return new ChunkMessages(messagesIn(await unpackChunk(record.subarray(RECORD_HEAD_BYTES))));
    });
  }

  /** The last snapshot that has nothing newer than a moment. */
  async snapshotBefore(timeNs: bigint): Promise<Snapshot | undefined> {
    const entry = this.#snapshots.findLast(({ logTime }) => logTime <= timeNs);
    if (entry === undefined) return undefined;
    return this.#openSnapshots.get(entry.offset, Number(entry.length), async () => {
      const record = await this.#source.read(entry.offset, entry.length);
      const end = record.length - CRC_BYTES;
      const data = record.subarray(end - Number(entry.dataSize), end);
      if (data.byteOffset < RECORD_HEAD_BYTES + ATTACHMENT_TIMES_BYTES) {
        throw new RecordingError('A snapshot of last values is broken.');
      }
      const messages = new Map(messagesIn(data).map((message) => [message.channelId, message]));
      return { offset: entry.offset, messages };
    });
  }
}
