/** The pieces of one write. */
export type FrameParts = readonly Buffer[];

/** From this size on a record is handed to the system where it lies instead of being copied. */
const LARGE_BYTES = 16 * 1024;

/** Bytes that a record of this length takes in the joined buffer. */
export function joinedSize(length: number): number {
  return length > LARGE_BYTES ? 0 : length;
}

/** Joins what is small in one piece of memory and keeps what is large where it lies, in order. */
export class JoinedParts {
  /** Buffer for small records; write at `pos`. */
  readonly bytes: Buffer;
  pos = 0;
  readonly #parts: Buffer[] = [];
  #finishedPos = 0;

  /** @param size of everything that is small, together, bytes */
  constructor(size: number) {
    this.bytes = Buffer.allocUnsafe(size);
  }

  /** Adds a record, small or large. */
  add(record: Uint8Array): void {
    if (record.length > LARGE_BYTES) {
      this.#finishSmall();
      this.#parts.push(Buffer.from(record.buffer, record.byteOffset, record.byteLength));
    } else {
      this.bytes.set(record, this.pos);
      this.pos += record.length;
    }
  }

  finish(): FrameParts {
    if (this.#parts.length === 0) return [this.bytes];
    this.#finishSmall();
    return this.#parts;
  }

  #finishSmall(): void {
    if (this.pos > this.#finishedPos) {
      this.#parts.push(this.bytes.subarray(this.#finishedPos, this.pos));
    }
    this.#finishedPos = this.pos;
  }
}
