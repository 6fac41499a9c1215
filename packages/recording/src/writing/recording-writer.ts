import { McapRecordBuilder, type Attachment, type Channel } from '@mcap/core';
import { Lz4Compressor } from '../compression/lz4-frame.ts';
import { encodeEnd, FileIndex, indexBytesOf } from '../mcap/file-index.ts';
import { OpenChunk } from '../mcap/open-chunk.ts';
import type { StoredPart } from '../mcap/stored-part.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { RecordingError } from '../records/recording-error.ts';
import type { Marker, RecordingEvent } from '../records/recording-event.ts';
import { headerToMetadata, PROFILE, type RecordingHeader } from '../records/recording-header.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';
import { Channels, LastValues, type WrittenTopic } from './channels.ts';

/** A chunk ends with this many bytes before compression … */
const CHUNK_BYTES = 1024 * 1024;
/** … or after this time, nanoseconds: that much is lost when the process is killed. */
const CHUNK_NS = 1_000_000_000n;
const MAX_SEQUENCE = 2 ** 32;

/** Numbers of a recording that is being written. */
export interface WriterStatistics {
  readonly records: number;
  /** Topics, once for each publisher. */
  readonly topics: number;
  readonly markers: number;
  /** Records that were refused because a file has no more than 65 535 channels. */
  readonly refusedRecords: number;
  /** Bytes of the file so far, without what `flush` would write. */
  readonly bytes: number;
  /** Bytes that the index will have at its end, about. */
  readonly indexBytes: number;
}

/**
 * Writes a recording. A chunk ends with 1 MiB or with the first record that is 1 s later than its first; call `flush`
 * once a second as well, so that silence does not keep the last records in memory. Events are in chunks of their own.
 */
export class RecordingWriter {
  readonly #sink: RecordingSink;
  readonly #file: FileIndex;
  readonly #channels: Channels;
  readonly #records: OpenChunk;
  readonly #events: OpenChunk;
  readonly #lastValues = new LastValues();
  readonly #writtenChannels: Set<number>;
  readonly #writtenSchemas: Set<number>;
  #position: bigint;
  #sequence: number;
  readonly #markers = new Set<string>();
  #recordCount = 0;
  #refusedRecords = 0;
  #indexBytes = 0;
  #written: Promise<void> = Promise.resolve();
  #failure: { readonly error: unknown } | undefined;

  private constructor(sink: RecordingSink, file: FileIndex) {
    const compressor = new Lz4Compressor();
    this.#sink = sink;
    this.#file = file;
    this.#channels = new Channels(file);
    this.#records = new OpenChunk(compressor);
    this.#events = new OpenChunk(compressor);
    this.#writtenChannels = new Set(file.channels.keys());
    // A channel without a schema has number 0.
    this.#writtenSchemas = new Set([0, ...file.schemas.keys()]);
    this.#position = sink.position();
    this.#sequence = Number(file.messageCount) % MAX_SEQUENCE;
  }

  /** Begins a file at the start of the sink. @throws the error of the sink */
  static async create(sink: RecordingSink, header: RecordingHeader): Promise<RecordingWriter> {
    const writer = new RecordingWriter(sink, new FileIndex());
    const builder = new McapRecordBuilder();
    builder.writeMagic();
    builder.writeHeader({ profile: PROFILE, library: `ubi-interact ${header.version}` });
    void writer.#write(builder.buffer);
    await writer.setHeader(header);
    return writer;
  }

  /** Continues a file whose end was cut off; the sink is where the data ended. @param file what it holds, which is changed */
  static resume(sink: RecordingSink, file: FileIndex): RecordingWriter {
    return new RecordingWriter(sink, file);
  }

  get statistics(): WriterStatistics {
    return {
      records: this.#recordCount,
      topics: this.#channels.recordChannels,
      markers: this.#markers.size,
      refusedRecords: this.#refusedRecords,
      bytes: Number(this.#position),
      indexBytes: this.#indexBytes,
    };
  }

  /** Statistics of the records written so far; topics with messages of other programs are left out. */
  get topics(): readonly WrittenTopic[] {
    return this.#channels.recordTopics;
  }

  /** Writes another header, which replaces those before it. @throws the error of the sink */
  async setHeader(header: RecordingHeader): Promise<void> {
    const builder = new McapRecordBuilder();
    const length = builder.writeMetadata({ name: PROFILE, metadata: headerToMetadata(header) });
    this.#file.metadata.push({ name: PROFILE, offset: this.#position, length });
    await this.#write(builder.buffer);
    this.#throwFailure();
  }

  /**
   * Adds a record; its bytes are copied.
   *
   * @returns a promise when a chunk was closed: await it to wait for the sink. Not waiting is allowed.
   * @throws the error of the sink, once it has failed
   */
  addRecord(record: RecordedRecord): Promise<void> | undefined {
    this.#throwFailure();
    const channel = this.#channels.ofRecord(record);
    if (channel === undefined) {
      this.#refusedRecords++;
      return undefined;
    }
    const { logTimeNs } = record;
    const isLater = !this.#records.isEmpty && logTimeNs - this.#records.firstTimeNs >= CHUNK_NS;
    const earlier = isLater ? this.#closeChunks() : undefined;
    this.#recordCount++;
    const message = this.#message(channel, logTimeNs, record.publishTimeNs, record.record);
    this.#lastValues.add(message);
    this.#add(this.#records, channel, message);
    return this.#records.byteLength >= CHUNK_BYTES ? this.#closeChunks() : earlier;
  }

  /** Adds an event. @throws the error of the sink, once it has failed */
  addEvent(event: RecordingEvent): void {
    this.#throwFailure();
    if (event.kind === 'client') this.#channels.nameClient(event.value.id, event.value.name);
    if (event.kind === 'marker') this.#countMarker(event.value);
    const channel = this.#channels.ofEvent(event.kind);
    const data = new TextEncoder().encode(JSON.stringify(event.value));
    this.#add(this.#events, channel, this.#message(channel, event.timeNs, event.timeNs, data));
    if (this.#events.byteLength >= CHUNK_BYTES) void this.#closeChunks();
  }

  /**
   * Copies an attachment or metadata of another file. Add nothing else before its promise is fulfilled.
   *
   * @throws the error of the sink; RecordingError when the part is broken
   */
  async addPart({ kind, entry, pieces }: StoredPart): Promise<void> {
    const offset = this.#position;
    for await (const piece of pieces()) {
      await this.#write(piece);
      this.#throwFailure();
    }
    const length = this.#position - offset;
    if (length !== entry.length) throw new RecordingError(`"${entry.name}" is broken.`);
    if (kind === 'attachment') this.#file.attachments.push({ ...entry, offset, length });
    else this.#file.metadata.push({ ...entry, offset, length });
  }

  /** Closes the chunk and waits until everything is with the sink. @throws the error of the sink */
  async flush(): Promise<void> {
    await this.#closeChunks();
    this.#throwFailure();
  }

  /** Writes the rest, indexes and footer. The sink stays open. @throws the error of the sink */
  async end(): Promise<void> {
    await this.flush();
    await this.#write(encodeEnd(this.#file, this.#position));
    this.#throwFailure();
  }

  #countMarker({ id, isRemoved }: Marker): void {
    if (isRemoved === true) this.#markers.delete(id);
    else this.#markers.add(id);
  }

  #message(channel: Channel, logTime: bigint, publishTime: bigint, data: Uint8Array) {
    const sequence = this.#sequence;
    this.#sequence = (sequence + 1) % MAX_SEQUENCE;
    this.#file.count(channel.id);
    return { channelId: channel.id, sequence, logTime, publishTime, data };
  }

  #add(chunk: OpenChunk, channel: Channel, message: Parameters<OpenChunk['addMessage']>[0]): void {
    if (!this.#writtenChannels.has(channel.id)) {
      const isNewSchema = !this.#writtenSchemas.has(channel.schemaId);
      chunk.addChannel(channel, this.#file, isNewSchema);
      this.#writtenChannels.add(channel.id);
      this.#writtenSchemas.add(channel.schemaId);
    }
    chunk.addMessage(message);
  }

  #closeChunks(): Promise<void> {
    for (const chunk of [this.#records, this.#events]) {
      if (chunk.isEmpty) continue;
      const { bytes, index } = chunk.close(this.#position);
      this.#file.chunks.push(index);
      this.#indexBytes += indexBytesOf(index);
      void this.#write(bytes);
    }
    const snapshot = this.#lastValues.snapshotAt(this.#position);
    if (snapshot !== undefined) this.#writeAttachment(snapshot);
    return this.#written;
  }

  #writeAttachment(attachment: Attachment): void {
    const { data, ...head } = attachment;
    const builder = new McapRecordBuilder();
    const length = builder.writeAttachment(attachment);
    const dataSize = BigInt(data.length);
    this.#file.attachments.push({ ...head, dataSize, offset: this.#position, length });
    void this.#write(builder.buffer);
  }

  /** Writes after everything before; does nothing once the sink has failed. Never rejects. */
  #write(bytes: Uint8Array): Promise<void> {
    this.#position += BigInt(bytes.length);
    this.#written = this.#written.then(async () => {
      if (this.#failure !== undefined) return;
      try {
        await this.#sink.write(bytes);
      } catch (error) {
        this.#failure = { error };
      }
    });
    return this.#written;
  }

  #throwFailure(): void {
    if (this.#failure !== undefined) throw this.#failure.error;
  }
}
