import { DATA_FORMATS, encodeRecord, type DataFormat, type RecordInit } from '@ubii/proto';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';

/** Options of an import of any format. */
export interface ImportOptions {
  /** Name of the recording. */
  readonly name: string;
  /** Version of the program that imports. */
  readonly version: string;
  /** When a recording begins whose times do not count from 1970, milliseconds since the Unix epoch. @default 0 */
  readonly startMs?: number;
  readonly signal?: { throwIfAborted(): void } | undefined;
  /** Told now and then: how much of the file was read, 0 to 1. */
  readonly onProgress?: ((share: number) => void) | undefined;
}

/** What became of a file. */
export interface ImportResult {
  readonly records: number;
  readonly markers: number;
  /** Sentences about parts that were left out. */
  readonly leftOut: readonly string[];
}

/** A value that becomes a record. */
export interface ImportedValue {
  readonly topic: string;
  readonly clientId: string;
  /** Undefined for a record without a value. */
  readonly format: DataFormat | undefined;
  readonly value: unknown;
  readonly publishTimeNs: bigint;
  readonly logTimeNs: bigint;
}

/** Markers of a recording of the master, at most. */
const MAX_MARKERS = 10_000;
const RECORDS_BETWEEN_PROGRESS = 1000;

/** Writes what is imported as a recording. */
export class ImportWriter {
  readonly #writer: RecordingWriter;
  readonly #options: ImportOptions;
  readonly #clients = new Set<string>();
  #markers = 0;
  #taken = 0;

  private constructor(writer: RecordingWriter, options: ImportOptions) {
    this.#writer = writer;
    this.#options = options;
  }

  static async create(
    sink: RecordingSink,
    options: ImportOptions,
    notes: string,
  ): Promise<ImportWriter> {
    const { name, version } = options;
    const header = { name, version, notes, kind: 'import', masterName: '', selection: '' } as const;
    return new ImportWriter(await RecordingWriter.create(sink, header), options);
  }

  /** Names a publisher before its first record. */
  addClient(id: string, name: string, timeNs: bigint): void {
    if (id === '' || this.#clients.has(id)) return;
    this.#clients.add(id);
    const value = { id, name, tags: [], state: 'unavailable' };
    this.#writer.addEvent({ kind: 'client', timeNs, value });
  }

  /** @throws TypeError when the value is not of the format; the reason of the signal; the error of the sink */
  async addValue(imported: ImportedValue, share: number): Promise<void> {
    this.#count(share);
    const { topic, clientId, format, value, publishTimeNs, logTimeNs } = imported;
    const record = encodeRecord({
      topic,
      clientId,
      timestampMs: Number(publishTimeNs) / 1e6,
      ...(format === undefined
        ? {}
        : { format, value: value ?? DATA_FORMATS[format].createDefault() }),
    } as RecordInit);
    await this.#writer.addRecord({ topic, clientId, record, publishTimeNs, logTimeNs });
  }

  addMarker(text: string, author: string, timeNs: bigint, share: number): void {
    this.#count(share);
    if (++this.#markers > MAX_MARKERS) return;
    const value = {
      id: `import-${this.#markers}`,
      timeMs: Number(timeNs) / 1e6,
      text,
      author,
      authorId: '',
      kind: 'import',
    };
    this.#writer.addEvent({ kind: 'marker', timeNs, value });
  }

  /** @throws RecordingError when there is nothing to keep */
  async end(leftOut: readonly string[]): Promise<ImportResult> {
    const { records } = this.#writer.statistics;
    if (records === 0 && this.#markers === 0) {
      throw new RecordingError(['The file has no values.', ...leftOut].join(' '));
    }
    await this.#writer.end();
    const markers = Math.min(this.#markers, MAX_MARKERS);
    const isCut = markers < this.#markers;
    const more = isCut ? [`Only the first ${MAX_MARKERS} markers were kept.`] : [];
    return { records, markers, leftOut: [...leftOut, ...more] };
  }

  #count(share: number): void {
    if (this.#taken++ % RECORDS_BETWEEN_PROGRESS !== 0) return;
    this.#options.signal?.throwIfAborted();
    this.#options.onProgress?.(share);
  }
}
