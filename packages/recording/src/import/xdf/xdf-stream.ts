import { RecordingError } from '../../records/recording-error.ts';
import type { RecordingSource } from '../../storage/recording-storage.ts';
import { BufferedSource } from '../buffered-source.ts';

/** Kinds of chunks that are read. Source: the specification "XDF 1.0", https://github.com/sccn/xdf/wiki/Specifications */
export const XDF_TAG = { fileHeader: 1, streamHeader: 2, samples: 3, clockOffset: 4 } as const;

/** One chunk of a file. */
interface XdfChunk {
  readonly tag: number;
  /** Where its content begins, after the tag. */
  readonly offset: number;
  readonly length: number;
}

/** Beginning of a file. */
const MARK = 'XDF:';

/** Chunks are read as a whole; programs write a few seconds into one. */
const MAX_CHUNK_BYTES = 256 * 1024 * 1024;

/** The chunks of an XDF file, up to where it is damaged. */
export class XdfSource {
  readonly size: number;
  readonly #file: BufferedSource;
  /** Where the file cannot be read any more, as a sentence. */
  damage: string | undefined;

  private constructor(file: BufferedSource) {
    this.#file = file;
    this.size = file.size;
  }

  /** @throws RecordingError when the source is no XDF file */
  static async open(source: RecordingSource): Promise<XdfSource> {
    const file = await BufferedSource.open(source);
    const [first, second, ...rest] = await file.read(0, MARK.length);
    if (first === 0x1f && second === 0x8b) {
      throw new RecordingError('Unpack the file first: it is compressed.');
    }
    const mark = String.fromCharCode(first ?? 0, second ?? 0, ...rest);
    if (mark !== MARK) throw new RecordingError('The file is no XDF file.');
    return new XdfSource(file);
  }

  /** Gives all chunks without their content, in order. */
  async *chunks(): AsyncGenerator<XdfChunk> {
    for (let offset = MARK.length; offset < this.size;) {
      const head = await this.#file.read(offset, 11);
      const bytes = head[0] ?? 0;
      const isLength = (bytes === 1 || bytes === 4 || bytes === 8) && head.length >= bytes + 3;
      const length = isLength ? lengthAt(head, bytes) : 0;
      const begin = offset + 1 + bytes;
      if (length < 2 || length > MAX_CHUNK_BYTES || begin + length > this.size) {
        this.damageAt(offset);
        return;
      }
      const tag = head[1 + bytes]! + head[2 + bytes]! * 0x100;
      yield { tag, offset: begin + 2, length: length - 2 };
      offset = begin + length;
    }
  }

  /** The content of a chunk. The bytes are valid until the next call. */
  content({ offset, length }: XdfChunk): Promise<Uint8Array> {
    return this.#file.read(offset, length);
  }

  /** Notes that the file cannot be read beyond a place; the first one counts. */
  damageAt(offset: number): void {
    const percent = Math.floor((offset / this.size) * 100);
    this.damage ??= `The file is damaged at byte ${offset}: what follows was not read (${100 - percent} % of the file).`;
  }
}

function lengthAt(head: Uint8Array, bytes: number): number {
  const view = new DataView(head.buffer, head.byteOffset + 1, bytes);
  if (bytes === 1) return view.getUint8(0);
  return bytes === 4 ? view.getUint32(0, true) : Number(view.getBigUint64(0, true));
}

const NUMBERS = {
  float32: { bytes: 4, read: (view: DataView, at: number) => view.getFloat32(at, true) },
  double64: { bytes: 8, read: (view: DataView, at: number) => view.getFloat64(at, true) },
  int8: { bytes: 1, read: (view: DataView, at: number) => view.getInt8(at) },
  int16: { bytes: 2, read: (view: DataView, at: number) => view.getInt16(at, true) },
  int32: { bytes: 4, read: (view: DataView, at: number) => view.getInt32(at, true) },
  int64: { bytes: 8, read: (view: DataView, at: number) => Number(view.getBigInt64(at, true)) },
} as const;

/** How values are stored. */
export type XdfFormat = keyof typeof NUMBERS | 'string';

/** Header of a stream. */
export interface XdfStream {
  readonly id: number;
  readonly name: string;
  readonly type: string;
  readonly format: XdfFormat;
  readonly channels: number;
  /** Names of the channels; empty when they have none. */
  readonly labels: readonly string[];
  /** Samples per second; 0 for an irregular rate. */
  readonly rateHz: number;
  readonly sourceId: string;
  readonly host: string;
}

/** One sample. */
export interface XdfSample {
  /** By the clock of the stream, seconds. */
  readonly time: number;
  readonly values: readonly (number | string)[];
}

const MAX_CHANNELS = 65_536;

/** Reads the header of a stream. @throws RecordingError when it is none */
export function parseStream(id: number, xml: string): XdfStream {
  const name = element(xml, 'name') || `stream-${id}`;
  const format = element(xml, 'channel_format');
  const channels = Number(element(xml, 'channel_count'));
  if (format !== 'string' && !Object.hasOwn(NUMBERS, format)) {
    throw new RecordingError(`Stream "${name}" has values of an unknown format: "${format}".`);
  }
  if (!Number.isInteger(channels) || channels < 0 || channels > MAX_CHANNELS) {
    throw new RecordingError(`Stream "${name}" has a wrong number of channels.`);
  }
  const described = /<channels>([\s\S]*?)<\/channels>/.exec(xml)?.[1] ?? '';
  const labels = [...described.matchAll(/<label>([\s\S]*?)<\/label>/g)].map(([, label]) =>
    unescaped(label!),
  );
  return {
    id,
    name,
    channels,
    format: format as XdfFormat,
    type: element(xml, 'type'),
    labels: labels.length === channels ? labels : [],
    rateHz: Number(element(xml, 'nominal_srate')) || 0,
    sourceId: element(xml, 'source_id'),
    host: element(xml, 'hostname'),
  };
}

/** Text of the first element of a name; empty when there is none. */
export function element(xml: string, name: string): string {
  const [, after] = xml.split(`<${name}>`, 2);
  const [content, end] = (after ?? '').split(`</${name}>`, 2);
  return end === undefined ? '' : unescaped(content!.trim());
}

const ENTITIES: Readonly<Record<string, string>> = {
  amp: '&',
  lt: '<',
  gt: '>',
  quot: '"',
  apos: "'",
};

function unescaped(text: string): string {
  return text.replace(/&(#x?[\da-f]+|\w+);/gi, (whole, name: string) => {
    if (!name.startsWith('#')) return ENTITIES[name] ?? whole;
    const code = name[1] === 'x' ? parseInt(name.slice(2), 16) : Number(name.slice(1));
    return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
  });
}

/** Reads the samples of one stream, chunk after chunk: a sample without a time follows the one before it. */
export class SampleReader {
  readonly #stream: XdfStream;
  #last = 0;

  constructor(stream: XdfStream) {
    this.#stream = stream;
  }

  /**
   * Reads the samples of a chunk.
   *
   * @param content after the number of the stream
   * @throws RangeError when it is damaged
   */
  *read(content: Uint8Array): Generator<XdfSample> {
    const { rateHz } = this.#stream;
    const cursor = new Cursor(content);
    const count = cursor.length();
    for (let i = 0; i < count; i++) {
      const hasTime = cursor.byte() !== 0;
      this.#last = hasTime ? cursor.number('double64') : this.#last + (rateHz > 0 ? 1 / rateHz : 0);
      yield { time: this.#last, values: this.#values(cursor) };
    }
  }

  #values(cursor: Cursor): (number | string)[] {
    const { channels, format } = this.#stream;
    const values: (number | string)[] = [];
    for (let i = 0; i < channels; i++) {
      values.push(format === 'string' ? cursor.text() : cursor.number(format));
    }
    return values;
  }
}

/** Reads values one after the other. */
class Cursor {
  readonly #bytes: Uint8Array;
  readonly #view: DataView;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  byte(): number {
    return this.#view.getUint8(this.#at++);
  }

  number(format: keyof typeof NUMBERS): number {
    const { bytes, read } = NUMBERS[format];
    this.#at += bytes;
    return read(this.#view, this.#at - bytes);
  }

  /** A number with the number of its bytes before it. */
  length(): number {
    const bytes = this.byte();
    this.#at += bytes;
    if (bytes === 1) return this.#view.getUint8(this.#at - 1);
    if (bytes === 4) return this.#view.getUint32(this.#at - 4, true);
    if (bytes === 8) return Number(this.#view.getBigUint64(this.#at - 8, true));
    throw new RangeError('The length of a value is damaged.');
  }

  text(): string {
    const length = this.length();
    if (this.#at + length > this.#bytes.length) throw new RangeError('A text is damaged.');
    this.#at += length;
    return new TextDecoder().decode(this.#bytes.subarray(this.#at - length, this.#at));
  }
}
