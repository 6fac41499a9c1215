import type { AttachmentIndex, ChunkIndex } from '@mcap/core';

import { byTime, expectChunk, messagesIn, type StoredMessage } from '../mcap/chunk-content.ts';
import { SNAPSHOT_NAME, type FileIndex } from '../mcap/file-index.ts';
import { storedAttachment, storedMetadata, type StoredPart } from '../mcap/stored-part.ts';
import { unpackChunk } from '../mcap/unpack-chunk.ts';
import { RecordingError } from '../records/recording-error.ts';
import { PROFILE } from '../records/recording-header.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import {
  ChunkAhead,
  endOf,
  MAX_READ_BYTES,
  neighbours,
  spanOf,
  type ByteSpan,
} from './chunk-ahead.ts';
import { LruCache } from './lru-cache.ts';

/** The messages of a chunk. */
class ChunkMessages {
  /** By log time. */
  readonly all: readonly StoredMessage[];
  #byChannel: Map<number, StoredMessage[]> | undefined;

  /** @param messages in the order of the file, which those of the same time keep */
  constructor(messages: StoredMessage[]) {
    this.all = messages.sort(byTime);
  }

  /** The last message of a channel that is not later than a moment. */
  latestAt(channelId: number, timeNs: bigint): StoredMessage | undefined {
    this.#byChannel ??= group(this.all);
    const messages = this.#byChannel.get(channelId);
    return messages?.findLast(({ logTimeNs }) => logTimeNs <= timeNs);
  }
}

function group(messages: readonly StoredMessage[]): Map<number, StoredMessage[]> {
  const groups = new Map<number, StoredMessage[]>();
  for (const message of messages) {
    const group = groups.get(message.channelId);
    if (group === undefined) groups.set(message.channelId, [message]);
    else group.push(message);
  }
  return groups;
}

/** Decompressed chunks that are kept: those between two snapshots, and some more. */
const CACHE_BYTES = 48 * 1024 * 1024;
/** What a message takes besides its bytes. */
const MESSAGE_BYTES = 256;
/** Small chunks that came along with others: their records are kept as they are in the file. */
const ALONG_BYTES = 4 * 1024 * 1024;
const SMALL_CHUNK_BYTES = 16 * 1024;
/** Chunks of events are small: what is between them is not worth a long read. */
const EVENT_LIMITS = { maxBytes: MAX_READ_BYTES, maxGapBytes: 32 * 1024 };
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
  readonly #along = new LruCache<Uint8Array>(ALONG_BYTES);
  /** Small chunks in the order of the file. */
  #small: readonly ChunkIndex[] | undefined;
  readonly #snapshots: readonly AttachmentIndex[];
  readonly #openSnapshots = new LruCache<Snapshot>(CACHE_BYTES / 4);

  constructor(source: RecordingSource, index: FileIndex) {
    this.#source = source;
    this.index = index;
    // One that is too long for a read is left out: what it holds is in the chunks as well. [RC-43]
    this.#snapshots = index.attachments.filter(
      ({ name, length }) => name === SNAPSHOT_NAME && length <= BigInt(READING_LIMITS.chunkBytes),
    );
  }

  /** The messages of a chunk. @throws RecordingError when it is broken */
  messagesOf(chunk: ChunkIndex): Promise<ChunkMessages> {
    return this.#kept(chunk, () => this.#recordOf(chunk));
  }

  /**
   * Returns a function that loads chunks one after the other, neighbours with one read.
   *
   * @param chunks in the order in which they are asked for
   * @param isOnce they are not kept, so that those that others use stay
   */
  inOrder(
    chunks: readonly ChunkIndex[],
    isOnce: boolean,
  ): (chunk: ChunkIndex) => Promise<ChunkMessages> {
    const ahead = new ChunkAhead({
      chunks,
      isKnown: (chunk) => this.#chunks.has(chunk.chunkStartOffset),
      read: (span) => this.#readSpan(span),
    });
    return (chunk) => {
      const load = (): Promise<Uint8Array> => ahead.recordOf(chunk);
      if (!isOnce) return this.#kept(chunk, load);
      return this.#chunks.find(chunk.chunkStartOffset) ?? unpacked(load(), chunk);
    };
  }

  /** Divides small chunks that are asked for together into groups, each of which `messagesOfAll` loads with one read. */
  groupsOf(chunks: readonly ChunkIndex[]): (readonly ChunkIndex[])[] {
    const isHere = ({ chunkStartOffset }: ChunkIndex): boolean =>
      this.#along.has(chunkStartOffset) || this.#chunks.has(chunkStartOffset);
    const missing = chunks.filter((chunk) => !isHere(chunk));
    return [...chunks.filter(isHere).map((chunk) => [chunk]), ...neighbours(missing, EVENT_LIMITS)];
  }

  async messagesOfAll(group: readonly ChunkIndex[]): Promise<ChunkMessages[]> {
    if (group.length === 1) return [await this.messagesOf(group[0]!)];
    const { from, until } = spanOf(group);
    const bytes = await this.#source.read(from, until - from);
    return Promise.all(
      group.map((chunk) => this.#kept(chunk, () => Promise.resolve(cutOut(bytes, from, chunk)))),
    );
  }

  #kept(chunk: ChunkIndex, load: () => Promise<Uint8Array>): Promise<ChunkMessages> {
    const { chunkStartOffset, uncompressedSize } = chunk;
    return this.#chunks.get(
      chunkStartOffset,
      Number(uncompressedSize),
      () => unpacked(load(), chunk),
      ({ all }) => all.length * MESSAGE_BYTES,
    );
  }

  #recordOf({ chunkStartOffset, chunkLength }: ChunkIndex): Promise<Uint8Array> {
    return this.#along.find(chunkStartOffset) ?? this.#source.read(chunkStartOffset, chunkLength);
  }

  /** Reads bytes, and keeps small chunks that were not asked for yet: those of events lie between others. */
  async #readSpan(span: ByteSpan): Promise<Uint8Array> {
    const bytes = await this.#source.read(span.from, span.until - span.from);
    for (const chunk of this.#smallChunksIn(span)) {
      const length = Number(chunk.chunkLength);
      const record = cutOut(bytes, span.from, chunk);
      void this.#along.get(chunk.chunkStartOffset, length, () => Promise.resolve(record));
    }
    return bytes;
  }

  #smallChunksIn({ from, until }: ByteSpan): ChunkIndex[] {
    this.#small ??= this.index.chunks
      .filter(({ chunkLength }) => chunkLength <= SMALL_CHUNK_BYTES)
      .sort((a, b) => (a.chunkStartOffset < b.chunkStartOffset ? -1 : 1));
    const first = firstFrom(this.#small, from);
    const past = this.#small.findIndex((chunk, i) => i >= first && endOf(chunk) > until);
    return this.#small.slice(first, past < 0 ? undefined : past);
  }

  /** Attachments and metadata of other programs, in the order of the file. */
  foreignParts(): StoredPart[] {
    const { attachments, metadata } = this.index;
    return [
      ...attachments
        .filter(({ name }) => name !== SNAPSHOT_NAME)
        .map((entry) => storedAttachment(this.#source, entry)),
      ...metadata
        .filter(({ name }) => name !== PROFILE)
        .map((entry) => storedMetadata(this.#source, entry)),
    ];
  }

  /** The last snapshot that has nothing newer than a moment. */
  async snapshotBefore(timeNs: bigint): Promise<Snapshot | undefined> {
    const entry = this.#snapshots.findLast(({ logTime }) => logTime <= timeNs);
    if (entry === undefined) return undefined;
    return this.#openSnapshots.get(entry.offset, Number(entry.length), async () => {
      const record = await this.#source.read(entry.offset, entry.length);
      const end = record.length - CRC_BYTES;
      const data = record.subarray(end - Number(entry.dataSize), end);
      if (data.byteOffset - record.byteOffset < RECORD_HEAD_BYTES + ATTACHMENT_TIMES_BYTES) {
        throw new RecordingError('A snapshot of last values is broken.');
      }
      const messages = new Map(messagesIn(data).map((message) => [message.channelId, message]));
      return { offset: entry.offset, messages };
    });
  }
}

async function unpacked(record: Promise<Uint8Array>, chunk: ChunkIndex): Promise<ChunkMessages> {
  const bytes = await record;
  expectChunk(bytes, chunk);
  return new ChunkMessages(messagesIn(await unpackChunk(bytes.subarray(RECORD_HEAD_BYTES))));
}

/** The record of a chunk, as a copy. @param from where the bytes begin in the file */
function cutOut(
  bytes: Uint8Array,
  from: bigint,
  { chunkStartOffset, chunkLength }: ChunkIndex,
): Uint8Array {
  const start = Number(chunkStartOffset - from);
  return bytes.slice(start, start + Number(chunkLength));
}

/** Place of the first chunk that does not begin before an offset. */
function firstFrom(chunks: readonly ChunkIndex[], offset: bigint): number {
  let [low, high] = [0, chunks.length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (chunks[middle]!.chunkStartOffset < offset) low = middle + 1;
    else high = middle;
  }
  return low;
}
