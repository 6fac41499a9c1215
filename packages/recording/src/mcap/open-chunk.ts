import { crc32 } from '@foxglove/crc';
import { McapChunkBuilder, McapRecordBuilder } from '@mcap/core';
import type { Channel, ChunkIndex, Message, MessageIndex } from '@mcap/core';
import type { Lz4Compressor } from '../compression/lz4-frame.ts';
import type { FileIndex } from './file-index.ts';

/** A chunk on its way into the file: its bytes and its entry in the index. */
export interface ClosedChunk {
  readonly bytes: Uint8Array;
  readonly index: ChunkIndex;
}

/** The chunk that messages are added to. */
export class OpenChunk {
  readonly #builder = new McapChunkBuilder({});
  readonly #compressor: Lz4Compressor;
  #firstTimeNs = 0n;

  constructor(compressor: Lz4Compressor) {
    this.#compressor = compressor;
  }

  get isEmpty(): boolean {
    return this.#builder.numMessages === 0;
  }

  get byteLength(): number {
    return this.#builder.byteLength;
  }

  /** Log time of the message that was added first. */
  get firstTimeNs(): bigint {
    return this.#firstTimeNs;
  }

  /** Makes a channel, and its schema, known before its first message. */
  addChannel(channel: Channel, file: FileIndex, isNewSchema: boolean): void {
    if (isNewSchema) this.#builder.addSchema(file.schemas.get(channel.schemaId)!);
    this.#builder.addChannel(channel);
  }

  addMessage(message: Message): void {
    if (this.isEmpty) this.#firstTimeNs = message.logTime;
    this.#builder.addMessage(message);
  }

  /** Encodes the chunk with its message indexes and begins the next one. @param offset where it goes in the file */
  close(offset: bigint): ClosedChunk {
    const builder = this.#builder;
    const content = builder.buffer;
    const records = this.#compressor.compress(content);
    const isSmaller = records.length < content.length;
    const chunk = {
      messageStartTime: builder.messageStartTime,
      messageEndTime: builder.messageEndTime,
      uncompressedSize: BigInt(content.length),
      uncompressedCrc: crc32(content),
      compression: isSmaller ? 'lz4' : '',
      records: isSmaller ? records : content,
    };
    const out = new McapRecordBuilder();
    const chunkLength = out.writeChunk(chunk);
    const indexes = writeMessageIndexes(out, builder.indices, offset + chunkLength);
    builder.reset();
    return {
      bytes: out.buffer,
      index: {
        messageStartTime: chunk.messageStartTime,
        messageEndTime: chunk.messageEndTime,
        chunkStartOffset: offset,
        chunkLength,
        ...indexes,
        compression: chunk.compression,
        compressedSize: BigInt(chunk.records.length),
        uncompressedSize: chunk.uncompressedSize,
      },
    };
  }
}

/** Writes the message indexes of a chunk. @param offset where they go in the file */
export function writeMessageIndexes(
  out: McapRecordBuilder,
  indexes: Iterable<MessageIndex>,
  offset: bigint,
): Pick<ChunkIndex, 'messageIndexOffsets' | 'messageIndexLength'> {
  const messageIndexOffsets = new Map<number, bigint>();
  let messageIndexLength = 0n;
  for (const index of indexes) {
    if (index.records.length === 0) continue;
    messageIndexOffsets.set(index.channelId, offset + messageIndexLength);
    messageIndexLength += out.writeMessageIndex(index);
  }
  return { messageIndexOffsets, messageIndexLength };
}
