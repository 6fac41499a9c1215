import { McapRecordBuilder, type ChunkIndex } from '@mcap/core';
import { encodeEnd, FileIndex, SNAPSHOT_NAME, SNAPSHOT_TYPE } from '../mcap/file-index.ts';
import { RECORD_SCHEMA_NAME } from '../records/event-schemas.ts';
import { PROFILE } from '../records/recording-header.ts';
import { EVENT_TOPICS } from '../records/recording-event.ts';
import { SAMPLE_START_NS } from './sample-records.ts';
import { repeatedLz4 } from './repeated-lz4.ts';

/** More than one read of Node can return: the process aborts. */
const THREE_GIB = 3n * 1024n ** 3n;
const RECORD_HEAD_BYTES = 9;
const CHANNEL_ID = 1;

/** A file of 129 bytes whose index says that its header has 3 GiB. */
export function metadataIndexOf3Gib(): Uint8Array<ArrayBuffer> {
  const builder = new McapRecordBuilder();
  builder.writeMagic();
  builder.writeHeader({ profile: PROFILE, library: 'x' });
  builder.writeDataEnd({ dataSectionCrc: 0 });
  const summaryStart = BigInt(builder.length);
  builder.writeMetadataIndex({ name: PROFILE, offset: 8n, length: THREE_GIB });
  builder.writeFooter({ summaryStart, summaryOffsetStart: 0n, summaryCrc: 0 });
  builder.writeMagic();
  return Uint8Array.from(builder.buffer);
}

/** A file whose index says that a chunk of markers has 3 GiB. */
export function markerChunkIndexOf3Gib(): Uint8Array<ArrayBuffer> {
  const index = indexOf('marker');
  index.chunks.push(chunkEntry({ chunkLength: THREE_GIB }));
  return fileOf(index);
}

/** The same of a chunk of records, which is read when the file is played. */
export function recordChunkIndexOf3Gib(): Uint8Array<ArrayBuffer> {
  const index = indexOf('record');
  index.chunks.push(chunkEntry({ chunkLength: THREE_GIB }));
  return fileOf(index);
}

/** A file whose index says that a snapshot of last values has 3 GiB, which is read when the file is played. */
export function attachmentIndexOf3Gib(): Uint8Array<ArrayBuffer> {
  const index = indexOf('record');
  const times = { logTime: SAMPLE_START_NS, createTime: SAMPLE_START_NS };
  index.attachments.push({
    ...times,
    name: SNAPSHOT_NAME,
    mediaType: SNAPSHOT_TYPE,
    offset: 8n,
    length: THREE_GIB,
    dataSize: THREE_GIB - 100n,
  });
  index.chunks.push(chunkEntry({}));
  return fileOf(index);
}

/** A small file with one chunk of so many markers, compressed by LZ4. @param count five million take more than 512 MiB of heap */
export function manyMarkers(count = 5_000_000): Uint8Array<ArrayBuffer> {
  const value = { id: 'm', timeMs: 0, text: '', author: '', authorId: '', kind: 'key' };
  const message = messageOf(new TextEncoder().encode(JSON.stringify(value)));
  return fileOfChunk('marker', message, count);
}

/** A file of 4.2 MB whose chunk has 1.1 GB when it is decompressed. @param bytes of the chunk */
export function lz4Bomb(bytes = 1_100_000_000): Uint8Array<ArrayBuffer> {
  return fileOfChunk('marker', new Uint8Array(RECORD_HEAD_BYTES), Math.ceil(bytes / 9));
}

/** A file without its end, whose chunk has so many messages: its index has to be rebuilt. */
export function manyMarkersWithoutEnd(count = 5_000_000): Uint8Array<ArrayBuffer> {
  const whole = manyMarkers(count);
  return whole.slice(0, -8);
}

/** A file whose chunk is a row of the same record. */
function fileOfChunk(
  kind: 'marker' | 'record',
  record: Uint8Array,
  count: number,
): Uint8Array<ArrayBuffer> {
  const index = indexOf(kind);
  const builder = new McapRecordBuilder();
  const compression = 'lz4';
  const records = repeatedLz4(record, count);
  const uncompressedSize = BigInt(record.length) * BigInt(count);
  const chunkLength = builder.writeChunk({
    messageStartTime: SAMPLE_START_NS,
    messageEndTime: SAMPLE_START_NS,
    uncompressedSize,
    uncompressedCrc: 0,
    compression,
    records,
  });
  const compressedSize = BigInt(records.length);
  index.chunks.push(chunkEntry({ chunkLength, compression, uncompressedSize, compressedSize }));
  index.messages.set(CHANNEL_ID, BigInt(count));
  return fileOf(index, builder.buffer);
}

/** Magic and header, the data, and an end of the index. */
function fileOf(index: FileIndex, data: Uint8Array = new Uint8Array()): Uint8Array<ArrayBuffer> {
  const start = startOfFile();
  const end = encodeEnd(index, BigInt(start.length + data.length));
  const file = new Uint8Array(start.length + data.length + end.length);
  file.set(start);
  file.set(data, start.length);
  file.set(end, start.length + data.length);
  return file;
}

function startOfFile(): Uint8Array {
  const builder = new McapRecordBuilder();
  builder.writeMagic();
  builder.writeHeader({ profile: PROFILE, library: 'x' });
  return builder.buffer;
}

function indexOf(kind: 'marker' | 'record'): FileIndex {
  const index = new FileIndex();
  const isMarker = kind === 'marker';
  const name = isMarker ? 'ubii.recording.Marker' : RECORD_SCHEMA_NAME;
  const messageEncoding = isMarker ? 'json' : 'protobuf';
  index.schemas.set(1, { id: 1, name, encoding: '', data: new Uint8Array() });
  index.channels.set(CHANNEL_ID, {
    id: CHANNEL_ID,
    schemaId: 1,
    topic: isMarker ? EVENT_TOPICS.marker : '/x',
    messageEncoding,
    metadata: new Map(),
  });
  return index;
}

/** An entry for a chunk at the start of the data. */
function chunkEntry(more: Partial<ChunkIndex>): ChunkIndex {
  return {
    messageStartTime: SAMPLE_START_NS,
    messageEndTime: SAMPLE_START_NS,
    chunkStartOffset: BigInt(startOfFile().length),
    chunkLength: 100n,
    messageIndexOffsets: new Map([[CHANNEL_ID, BigInt(startOfFile().length)]]),
    messageIndexLength: 0n,
    compression: '',
    compressedSize: 0n,
    uncompressedSize: 0n,
    ...more,
  };
}

function messageOf(data: Uint8Array): Uint8Array {
  const builder = new McapRecordBuilder();
  const times = { logTime: SAMPLE_START_NS, publishTime: SAMPLE_START_NS };
  builder.writeMessage({ channelId: CHANNEL_ID, sequence: 0, ...times, data });
  return builder.buffer;
}
