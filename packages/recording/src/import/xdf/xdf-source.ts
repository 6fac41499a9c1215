import { BufferedSource } from '../buffered-source.ts';
import { RecordingError } from '../../records/recording-error.ts';
import type { RecordingSource } from '../../storage/recording-storage.ts';

/** Kinds of chunks that are read. Source: the specification "XDF 1.0", https://github.com/sccn/xdf/wiki/Specifications */
export const XDF_TAG = { fileHeader: 1, streamHeader: 2, samples: 3, clockOffset: 4 } as const;

/** One chunk of a file. */
export interface XdfChunk {
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
